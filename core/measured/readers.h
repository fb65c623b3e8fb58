// One reader per format, from bytes to a measurement. Internal to loadMeasurement.
#pragma once

#include "core/measured/load.h"

namespace reflectance {

/// What every reader is told.
struct ReadContext {
    std::string file; ///< for sentences
    ReadOptions options;
};

[[nodiscard]] Result<Measurement> readCsv(std::string_view text, const ReadContext& context);
[[nodiscard]] Result<Measurement> readOpenMaterial(std::string_view text, const ReadContext& context);
[[nodiscard]] Result<Measurement> readMerl(std::string_view bytes, const ReadContext& context);
[[nodiscard]] Result<Measurement> readRgl(std::string_view bytes, const ReadContext& context);
[[nodiscard]] Result<Measurement> readCornell(std::string_view text, const ReadContext& context);
[[nodiscard]] Result<Measurement> readZemax(std::string_view text, const ReadContext& context);
/// CUReT comes in two files: the 205 geometries and the 61 surfaces.
[[nodiscard]] Result<Measurement> readCuret(std::string_view geometries, const std::string& geometriesFile,
                                            std::string_view surfaces, const ReadContext& context);

/// No BRDF is larger; readers refuse numbers beyond, so that interpolation cannot overflow.
inline constexpr double largestBrdf = 1e100;

/// Whether the bytes begin as MERL does: three plausible dimensions.
[[nodiscard]] bool looksLikeMerl(std::string_view bytes);

/// Counts samples, holes and negatives of a finished grid where the reader did not, makes a sample with one unmeasured channel a hole, and checks
/// the grid. For every reader of a grid to end with.
[[nodiscard]] Result<Measurement> finished(Table table, const ReadContext& context);

} // namespace reflectance
