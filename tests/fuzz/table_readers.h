// The readers of measured surfaces behind the face that all readers have.
#pragma once

#include "core/measured/measurement.h"
#include "tests/fuzz/readers.h"

namespace reflectance::fuzz {

/// CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, Zemax, and CUReT's two files as one.
[[nodiscard]] std::vector<Reader> tableReaders();

/// Bytes of memory per byte of file that a measured surface may take.
inline constexpr std::size_t mostOfTable = 64;

/// Finite numbers or holes on ascending angles, no more of them than the file can hold; a look-up anywhere gives finite
/// numbers or nothing. The promise that is broken in words; empty when all are kept.
[[nodiscard]] std::string brokenPromise(const Measurement& measurement, std::size_t bytes);

} // namespace reflectance::fuzz
