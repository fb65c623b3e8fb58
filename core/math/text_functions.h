// What shared texts call beyond shading_language.h: whole numbers without a sign, and functions that models do without.
#pragma once

#include "core/math/shading_language.h"

#include <cmath>
#include <cstdint>

namespace reflectance {

using uint = std::uint32_t; ///< GLSL's: 32 bits, wraps

using std::cos;
using std::log;

} // namespace reflectance
