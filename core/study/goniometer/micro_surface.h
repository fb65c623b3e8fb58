// Rough surfaces under the microscope: made by rule, or from a picture of heights or a mesh.
#pragma once

#include "core/base/result.h"
#include "core/study/goniometer/patch.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reflectance {

struct MicroSurface {
    std::string text;           ///< what it was asked for with: the same text gives the same surface
    std::vector<Patch> patches; ///< equal shares of the mean plane, each among its own kind

    /// Of all coordinates: whether a file still holds what it held.
    [[nodiscard]] std::uint64_t fingerprint() const;
    [[nodiscard]] std::size_t triangles() const;
    [[nodiscard]] double slope() const; ///< root mean square over all patches, along x and y together, as a tangent
};

/// Most samples of a height field; mirrored tiling counts four times.
inline constexpr std::size_t mostHeights = std::size_t{1} << 20U;

/// "flat";
/// "vgrooves:slope=30": symmetric grooves along y whose walls rise by so many degrees; "vgrooves:sigma=30": slopes of density
/// exp(-a^2 / 2 sigma^2) sin a, which is the distribution of Oren and Nayar, at 32 quantiles, each among its own kind;
/// "gaussian:sigma=20,correlation=0.05": Gaussian heights with the correlation exp(-(r / correlation)^2), slopes along any line
/// with the standard deviation tan(sigma); correlation in periods; "cells=256" per side, "seed=1";
/// "scratches:sigma=20,correlation=0.05": the same across x only, so that grooves run along y;
/// a path, ".png", ".exr", ".pfm" or ".hdr", with ":height=0.1": heights, value 1 standing for 0.1 of the picture's longer side
/// (a PNG's code values count as they are); mirrored into a tile, or as it is with ",tile=wrap";
/// any other path, or the name of a stock mesh: a mesh, seen along its thinnest side or "up=x|y|z", mirrored into a tile.
/// Refused in a sentence: unknown names, heights that are not finite or all the same, too many of them, a mesh with gaps.
[[nodiscard]] Result<MicroSurface> microSurface(const std::string& text);

/// A generator with its defaults, for menus: name, text and a sentence.
struct SurfaceKind {
    const char* name;
    const char* initial;
    const char* about;
};
[[nodiscard]] const std::vector<SurfaceKind>& surfaceKinds();

} // namespace reflectance
