// What separates two states of the scene, in a word or two: the names of undo's steps.
#pragma once

#include "app/explorer/comparison.h"
#include "app/explorer/exhibition.h"

#include <optional>
#include <string>

namespace reflectance::explorer {

/// Everything that undo brings back: the scene, what is compared in it, and whose scene it is.
struct Moment {
    Scene scene;
    bool comparing = false;
    CompareMode mode = CompareMode::SideBySide;
    std::optional<BeforeClay> beforeClay;
    std::optional<PutAside> putAside;

    friend bool operator==(const Moment&, const Moment&) = default;
};

/// "Exponent", "Move key", "B: Model", "Orbit"; "Scene" where most of it is another one. The moments must differ.
[[nodiscard]] std::string nameOfChange(const Moment& before, const Moment& after);

/// Whether the two differ in the camera and in nothing else.
[[nodiscard]] bool onlyCameraDiffers(const Moment& a, const Moment& b);

/// Whether one camera is the other, nearer or farther in the same direction.
[[nodiscard]] bool isZoom(const Camera& a, const Camera& b);

/// Whether the two differ in the wish for smooth normals and in nothing else.
[[nodiscard]] bool onlySmoothingDiffers(const Moment& a, const Moment& b);

} // namespace reflectance::explorer
