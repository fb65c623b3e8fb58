// The lines of a text file with their numbers, without their ends (LF or CRLF). Internal to the readers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace reflectance {

class Lines {
public:
    explicit Lines(std::string_view text) : rest_(text) {}

    /// The next line; nothing at the end of the text.
    [[nodiscard]] std::optional<std::string_view> next()
    {
        if (rest_.empty())
            return std::nullopt;
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        return line;
    }

    [[nodiscard]] long number() const { return number_; } ///< of the line given last, 1-based

private:
    std::string_view rest_;
    long number_ = 0;
};

/// What a file says, fit for a message: at most 20 characters, unprintable ones as '?', in quotation marks.
[[nodiscard]] inline std::string quotedPiece(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text.substr(0, 20))
        result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > 20 ? "...\"" : "\"");
}

/// A name from a file, fit for a report: at most 80 characters, unprintable ones as '?'.
[[nodiscard]] inline std::string printable(std::string_view text)
{
    std::string result;
    for (const char c : text.substr(0, 80))
        result += c >= ' ' && c <= '~' ? c : '?';
    return result;
}

} // namespace reflectance
