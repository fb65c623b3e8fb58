// From the GLSL of a shared text to the body of a C++ class template: while building, and where a model is exported.
#pragma once

#include <string>
#include <string_view>

namespace reflectance {

/// The text with T for float, Vec3<T> for vec3 (and so on), TexelBuffer<T> for samplerBuffer and lit<T>(0.33) for literals
/// with a point (whole numbers stay int); a uniform becomes a data member. Comments go unless they are kept, line ends
/// stay: after a #line, errors, coverage and debuggers point into the .glsl file.
[[nodiscard]] std::string instantiated(std::string_view code, bool keepComments = false);

} // namespace reflectance
