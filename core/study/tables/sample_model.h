// A model of the catalogue as the function that a table samples.
#pragma once

#include "core/measured/resample.h"
#include "core/reflectance/catalogue.h"

#include <span>

namespace reflectance {

/// 1 where the model is grey at these values, 3 where each channel goes its own way, 9 where channels mix.
[[nodiscard]] std::size_t channelsOf(const Model& model, std::span<const double> values);

/// f = factor / (pi N.L) in double precision. With fewer than 9 channels, the colour that white light gets: where channels
/// mix, the sums of K's rows.
[[nodiscard]] BrdfFunction brdfOf(const Model& model, std::vector<double> values, std::size_t channels);

/// The model on a grid, with the error of the grid's interpolation.
struct SampledModel {
    Table table;
    ResamplingError error;
    bool isUnderWhite = false; ///< the model mixes channels, and the table holds three
};

/// `mostChannels` is 3 for a format that holds no matrix, else 9.
[[nodiscard]] SampledModel sampledModel(const Model& model, const std::vector<double>& values, const GridShape& shape,
                                        Interpolation interpolation, std::size_t mostChannels);

} // namespace reflectance
