// What a hand takes hold of in a picture, beside the handles of lights.
#pragma once

#include <cstddef>

namespace reflectance {

enum class Grip { Spot, Edge, Terminator };

struct Grasp {
    Grip grip = Grip::Spot;
    std::size_t light = 0; ///< index into the scene's lights
    double pixels = 0.0;   ///< from the cursor to what is taken, to first order; 0 inside a spot

    friend bool operator==(const Grasp&, const Grasp&) = default;
};

} // namespace reflectance
