// The stability lens: how many significant digits a cheaper arithmetic keeps of what double gives, pixel by pixel.
#pragma once

#include "core/image/image.h"
#include "core/reflectance/precision.h"
#include "core/render/progress.h"
#include "core/render/view_samples.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace reflectance {

/// What is held against double. Half is float arithmetic whose picture is kept in 16-bit floats.
enum class LensKind { Float, Half, Simd, Glsl };

inline constexpr LensKind lensKinds[] = {LensKind::Float, LensKind::Half, LensKind::Simd, LensKind::Glsl};

[[nodiscard]] std::string_view nameOf(LensKind kind); ///< "float", "half", "simd", "glsl"
[[nodiscard]] double mostDigits(LensKind kind);       ///< 7.2 for 24 bits, 3.3 for 11

/// What a pixel is painted for. Where several hold, the first of these counts.
enum class LensMark : std::uint8_t {
    Background, ///< nothing but background: no model computes here
    NotANumber, ///< in the arithmetic that is looked at
    Infinite,
    Negative,     ///< a channel below 0, in double or in that arithmetic
    AbovePassive, ///< some light comes from where the surface sends on more than arrives
    Digits,
};

struct LensPixel {
    LensMark mark = LensMark::Background;
    float digits = 0.0F; ///< kept by the worst channel, 0 .. mostDigits
};

struct LensMap {
    int width = 0, height = 0;
    std::vector<LensPixel> pixels; ///< rows from the top

    [[nodiscard]] const LensPixel& at(int x, int y) const
    {
        return pixels[Image::pixelCount(width, y) + static_cast<std::size_t>(x)];
    }
};

/// Significant decimal digits that `got` has in common with `exact`: -log10 of the relative error, 0 .. most. Numbers
/// below the smallest normal float count as 0; of an exact 0 nothing but 0 keeps a digit.
[[nodiscard]] double digitsKept(double exact, double got, double most);

/// The samples shaded in that arithmetic; not for Glsl, which the renderer draws.
[[nodiscard]] Image shadedFor(LensKind kind, const ViewSamples& samples, const Scene& scene,
                              Progress* progress = nullptr);

/// The map of a view: `image` is its picture in the arithmetic `kind` (shadedFor, or what GL drew of these samples).
/// Nothing where `progress` is cancelled.
[[nodiscard]] std::optional<LensMap> lensMap(LensKind kind, const ViewSamples& samples, const Image& image,
                                             const Scene& scene, Progress& progress);

struct LensFigures {
    std::size_t covered = 0, notANumber = 0, infinite = 0, negative = 0, abovePassive = 0;
    double fewest = 0.0, median = 0.0; ///< digits, over the pixels that are painted by digits; 0 where there are none
};
[[nodiscard]] LensFigures figuresOf(const LensMap& map);

} // namespace reflectance
