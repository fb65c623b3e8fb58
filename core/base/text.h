// Small text helpers shared by parsers and messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// Without leading and trailing blanks, tabs and line ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The pieces between separators; "a;;b" gives three pieces, the middle one empty; "" gives one empty piece.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The pieces between runs of blanks and tabs; never empty ones.
[[nodiscard]] std::vector<std::string_view> words(std::string_view text);

/// The whole of `text` as a double (also inf and nan), independent of the locale; nothing if anything is left over.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The whole of `text` as an integer; nothing if anything is left over or it does not fit.
[[nodiscard]] std::optional<long> parseInteger(std::string_view text);

/// Shortest decimal form that reads back to the same double.
[[nodiscard]] std::string shortest(double value);

/// As printf("%.*g").
[[nodiscard]] std::string general(double value, int digits);

/// The candidate with the smallest edit distance to `name`; empty if there is no candidate.
[[nodiscard]] std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string>& names, std::string_view separator = ", ");

/// Lower case of ASCII letters.
[[nodiscard]] std::string lowered(std::string_view text);

} // namespace reflectance
