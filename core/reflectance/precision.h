// The arithmetic in which a model is evaluated.
#pragma once

#include <string_view>

namespace reflectance {

/// Double is the truth. Simd is float in lanes, with the widest instruction set that this processor has.
/// Glsl runs in the GL renderer.
enum class Precision { Double, Float, Simd, Glsl };

[[nodiscard]] constexpr std::string_view nameOf(Precision precision)
{
    constexpr std::string_view names[] = {"double", "float", "simd", "glsl"};
    return names[static_cast<int>(precision)];
}

} // namespace reflectance
