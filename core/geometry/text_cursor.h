// Walks through the text of a mesh file once, without copying. Lines end in LF, CRLF or CR; a backslash at the end of a
// line continues it; '#' starts a comment.
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace reflectance {

class TextCursor {
public:
    explicit TextCursor(std::string_view text) : at_(text.data()), begin_(at_), end_(at_ + text.size()) {}

    [[nodiscard]] bool atEnd() const { return at_ == end_; }
    [[nodiscard]] long line() const { return line_; }
    [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

    /// True when nothing but blanks and a comment is left on this line.
    [[nodiscard]] bool atLineEnd()
    {
        skipBlanks();
        return at_ == end_ || isLineBreak(*at_) || *at_ == '#';
    }

    void nextLine()
    {
        bool inComment = false; // a path in a comment may end in a backslash: it must not swallow the next line
        while (at_ != end_ && !isLineBreak(*at_)) {
            inComment = inComment || *at_ == '#';
            if (inComment || *at_ != '\\' || !skipContinuation())
                ++at_;
        }
        if (at_ != end_)
            skipLineBreak();
    }

    /// To `next`, a place of the text that stands behind this line's break.
    void jumpBehindLine(const char* next)
    {
        at_ = next;
        ++line_;
    }

    /// Past lines that hold nothing; false at the end of the text.
    [[nodiscard]] bool toNextContent()
    {
        while (!atEnd() && atLineEnd())
            nextLine();
        return !atEnd();
    }

    /// The next word of this line; empty at its end.
    [[nodiscard]] std::string_view word()
    {
        skipBlanks();
        const char* const first = at_;
        while (at_ != end_ && !isBlank(*at_) && !isLineBreak(*at_) && *at_ != '#')
            ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }

    /// The next number of this line, also nan and inf, whatever follows it at once; infinite when too large for a
    /// double, 0 when too small. Nothing, and no step, where no number stands.
    [[nodiscard]] std::optional<double> number()
    {
        skipBlanks();
        const char* const first = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        double value = 0.0;
        const auto [stop, error] = std::from_chars(first, end_, value);
        if (stop == first)
            return std::nullopt;
        at_ = stop;
        if (error == std::errc::result_out_of_range)
            return isTiny({first, stop}) ? 0.0 : std::numeric_limits<double>::infinity();
        return value;
    }

    /// The next integer; values beyond 64 bits become the largest. Nothing, and no step, where none stands.
    [[nodiscard]] std::optional<long long> integer()
    {
        skipBlanks();
        const char* const first = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        long long value = 0;
        const auto [stop, error] = std::from_chars(first, end_, value);
        if (stop == first)
            return std::nullopt;
        at_ = stop;
        return error == std::errc{} ? value : std::numeric_limits<long long>::max();
    }

    /// Steps over `wanted` when it is the next character.
    [[nodiscard]] bool accept(char wanted)
    {
        if (at_ == end_ || *at_ != wanted)
            return false;
        ++at_;
        return true;
    }

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool isLineBreak(char c) { return c == '\n' || c == '\r'; }

    /// Of a number beyond the range of double: is it beyond the small end?
    static bool isTiny(std::string_view number)
    {
        const std::size_t exponent = number.find_first_of("eE");
        if (exponent != std::string_view::npos)
            return number.substr(exponent + 1).starts_with('-');
        return number.substr(number.starts_with('-') ? 1 : 0).starts_with('0');
    }

    void skipBlanks()
    {
        while (at_ != end_) {
            if (isBlank(*at_))
                ++at_;
            else if (*at_ != '\\' || !skipContinuation())
                return;
        }
    }

    /// A backslash that ends its line: over both.
    bool skipContinuation()
    {
        const char* next = at_ + 1;
        while (next != end_ && isBlank(*next))
            ++next;
        if (next == end_ || !isLineBreak(*next))
            return false;
        at_ = next;
        skipLineBreak();
        return true;
    }

    void skipLineBreak()
    {
        const bool isPair = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
        at_ += isPair ? 2 : 1;
        ++line_;
    }

    const char* at_;
    const char* begin_;
    const char* end_;
    long line_ = 1;
};

} // namespace reflectance
