// Measured surfaces from files. The content decides what a file is: three formats share the ending .bsdf, two .brdf.
#pragma once

#include "core/measured/measurement.h"

namespace reflectance {

struct ReadOptions {
    std::size_t surface = 1; ///< which one, counted from 1, where a file holds several (CUReT; rotations of Zemax)
    std::optional<double> wavelength = {}; ///< nm: take this one of a spectral file instead of a colour
};

/// CSV, OpenMATERIAL 3D, MERL, RGL, Cornell or Zemax from the bytes of a file; `file` is for sentences. Memory stays below
/// 64 sizes of the file.
[[nodiscard]] Result<Measurement> readMeasurement(std::string_view bytes, const std::string& file,
                                                  const ReadOptions& options = {});

/// The same from a path. CUReT, which comes as table.txt and abrdf.dat, is read from either of the two.
[[nodiscard]] Result<Measurement> loadMeasurement(const std::string& path, const ReadOptions& options = {});

} // namespace reflectance
