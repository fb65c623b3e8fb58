// A camera's measured response, read from a file: what it makes of linear light, channel by channel.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// Evenly spaced from light 0 to 1, linear between; four floats each, red, green, blue and nothing: a shader's texels.
struct ResponseCurve {
    std::vector<float> texels;
    std::vector<double> numbers; ///< the same, for what runs in double

    [[nodiscard]] int count() const { return static_cast<int>(texels.size() / 4); }
    friend bool operator==(const ResponseCurve&, const ResponseCurve&) = default;
};

/// CSV: light, then one response or red, green and blue, on every line; a first line of names and lines that start with
/// # are passed over. Light rises from line to line and is divided by its last value, responses by their largest; they may not fall.
/// Between lines the curve is linear; it is sampled at 4097 places. At most 100,000 lines.
[[nodiscard]] Result<ResponseCurve> parseResponseCurve(std::string_view csv, const std::string& file);
[[nodiscard]] Result<ResponseCurve> readResponseCurve(const std::string& file);

} // namespace reflectance
