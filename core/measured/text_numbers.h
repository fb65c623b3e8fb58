// Numbers of a text whose line breaks mean nothing, or little. Internal to the readers.
#pragma once

#include "core/base/text.h"
#include "core/measured/lines.h"

namespace reflectance {

/// One number after the other, across lines; '#' begins a comment.
class TextNumbers {
public:
    explicit TextNumbers(std::string_view text) : lines_(text) {}

    /// The next word; empty at the end of the text.
    [[nodiscard]] std::string_view word()
    {
        while (next_ == words_.size()) {
            const auto line = lines_.next();
            if (!line)
                return {};
            words_ = words(line->substr(0, line->find('#')));
            next_ = 0;
        }
        return words_[next_++];
    }

    [[nodiscard]] bool atEnd()
    {
        if (word().empty())
            return true;
        --next_;
        return false;
    }

    [[nodiscard]] long line() const { return lines_.number(); }

private:
    Lines lines_;
    std::vector<std::string_view> words_;
    std::size_t next_ = 0;
};

} // namespace reflectance
