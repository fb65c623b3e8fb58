// Numbers as people write them: 10 000 000 as 10⁷, 0.0000019 as 1.9×10⁻⁶.
#pragma once

#include <cstddef>
#include <string>

namespace reflectance::explorer {

/// At most `digits` significant digits; a power of ten where there are more than five places before or three after the
/// point. Not finite values as "∞", "−∞" and "not a number".
[[nodiscard]] std::string written(double value, int digits);

/// 69451 as "69 451", with a narrow space.
[[nodiscard]] std::string grouped(std::size_t count);

/// "0.34 ms", "12.3 ms", "1.24 s".
[[nodiscard]] std::string duration(double milliseconds);

} // namespace reflectance::explorer
