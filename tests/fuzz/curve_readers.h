// The readers of curves: spectra, and what cameras make of light.
#pragma once

#include "tests/fuzz/readers.h"

namespace reflectance::fuzz {

[[nodiscard]] std::vector<Reader> curveReaders();

} // namespace reflectance::fuzz
