// What separates the pictures of two variants: figures over the object, and a map of the signed difference.
#pragma once

#include "core/image/image.h"
#include "core/render/progress.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// Over the pixels that the object covers; linear, before the sensor, but for dE2000.
struct DifferenceFigures {
    bool identical = false; ///< every channel has the same bits
    std::size_t pixels = 0;
    double rmse = 0.0, maxAbs = 0.0;            ///< over all channels
    std::optional<double> deltaEP95, deltaEMax; ///< dE2000 as a display shows them; none where it was not asked for
    std::optional<double> flipMean;             ///< FLIP, mean over the object; with the same condition
    bool ofRegion = false;                      ///< of a part of the picture only
};

/// A part of a picture, as shares of its width and height, 0 .. 1.
struct Region {
    double left = 0.0, top = 0.0, right = 1.0, bottom = 1.0;

    friend bool operator==(const Region&, const Region&) = default;
};

/// B - A in luminance as 8-bit sRGB, rows from the top: blue where B is darker, red where it is brighter, full colour from
/// `scale` on; dark where no object is.
struct DifferencePicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    double scale = 0.0;
    DifferenceFigures figures;
};

/// The smallest of 1, 2 and 5 times a power of ten that is not below `largest`; 1 for what is no positive number.
[[nodiscard]] double roundScale(double largest);

/// Both pictures are of the same view. dE2000 and FLIP take long: only where `perceived`. `exposure` is the sensor's. The
/// figures are of the region's pixels where one is given, the map is of all. Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<DifferencePicture> differenceOf(const Image& a, const Image& b, double exposure,
                                                            bool perceived, Progress& progress,
                                                            const std::optional<Region>& region = {});

/// The region's pixels, at least one.
[[nodiscard]] Image cropped(const Image& image, const Region& region);

/// "RMSE 0.0123, largest 0.2; dE2000 ..." for the figures, or a sentence where there is nothing to measure.
[[nodiscard]] std::string figuresText(const std::optional<DifferenceFigures>& figures);

} // namespace reflectance::explorer
