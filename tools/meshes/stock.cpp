#include "tools/meshes/stock.h"

namespace reflectance::stock {

const std::vector<StockMesh>& all()
{
    static const std::vector<StockMesh> meshes{
        {"mug", "Clay mug with handle, in centimetres", mug, 3},
        {"sphere", "Unit sphere", sphere, 4},
        {"torus_knot", "Tube along a (2,3) torus knot", torusKnot, 4},
        {"cube", "Cube with hard edges", cube, 4},
        {"wavy_plane", "Square with waves", wavyPlane, 4},
        {"teapot", "Newell's teapot", teapot, 4},
        {"vase", "Thrown vase with a flared lip, in centimetres", vase, 3},
    };
    return meshes;
}

} // namespace reflectance::stock
