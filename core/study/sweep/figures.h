// One cell computed: its picture, and how far that is from the double truth.
#pragma once

#include "core/image/image.h"
#include "core/render/progress.h"
#include "core/scene/scene.h"
#include "core/study/sweep/kept_meshes.h"
#include "core/study/sweep/study.h"

#include <cstddef>

namespace reflectance {

/// Of linear values before the sensor. Mean and largest are over the channels of pixels that the object fills wholly (0 where
/// there is none); the differences are to double on the same samples, over all pixels, as in core/image/compare.h and
/// core/image/perceived.h.
struct Figures {
    double covered = 0.0; ///< share of the picture that shows the object, 0 .. 1
    double mean = 0.0, largest = 0.0;
    std::size_t negative = 0, nonFinite = 0; ///< pixels
    double rmse = 0.0, maxAbs = 0.0;
    double deltaEMean = 0.0, deltaEMax = 0.0; ///< dE2000 over the pixels that show the object
    double flip = 0.0;                        ///< mean over the whole picture
    double milliseconds = 0.0;                ///< one shading of the kept samples
};

struct ComputedCell {
    Figures figures;
    Image image;
    Sensor sensor;
};

/// The error says why the cell cannot be rendered, or that it was stopped.
[[nodiscard]] Result<ComputedCell> computeCell(const Cell& cell, const std::string& folder, KeptMeshes& meshes,
                                               Progress* progress = nullptr);

} // namespace reflectance
