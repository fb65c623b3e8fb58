// The stock meshes, each made by a formula of its own.
#pragma once

#include "tools/meshes/shape.h"

namespace reflectance::stock {

[[nodiscard]] Shape mug();
[[nodiscard]] Shape sphere();
[[nodiscard]] Shape torusKnot();
[[nodiscard]] Shape cube();
[[nodiscard]] Shape wavyPlane();
[[nodiscard]] Shape teapot();
[[nodiscard]] Shape vase();

struct StockMesh {
    std::string name;  ///< "mug": the file is meshes/mug.obj
    std::string title; ///< its first line
    Shape (*make)();
    int decimals; ///< of the positions: enough for the shape, few enough for the file
};
[[nodiscard]] const std::vector<StockMesh>& all();

} // namespace reflectance::stock
