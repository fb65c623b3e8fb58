// A mesh file's text in parts, so that several threads can read it, and so that a file need not lie in memory as a whole.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace reflectance {

class TextParts {
public:
    /// What a part's text may lie in; it is kept by whoever asks for parts, and used again for the next.
    struct Buffer {
        std::unique_ptr<char[]> bytes;
        std::size_t capacity = 0;
    };

    /// Of a text at hand: its parts lie in the text itself. A part size of 0 is usualSize.
    explicit TextParts(std::string_view text, std::size_t partSize = 0);
    /// Of the first `fileSize` bytes of a regular file, those of a byte order mark at its start left out.
    [[nodiscard]] static Result<TextParts> ofFile(const std::string& path, std::uintmax_t fileSize,
                                                  std::size_t partSize = 0);
    TextParts(TextParts&&) noexcept;
    TextParts& operator=(TextParts&&) noexcept;
    ~TextParts();

    /// The next part, which ends with the text or with a line that no backslash continues; empty after the last one. It
    /// stays until `buffer` is handed in again. An Error where the file ends too early.
    [[nodiscard]] Result<std::string_view> next(Buffer& buffer);

    [[nodiscard]] std::uintmax_t size() const { return size_; }
    [[nodiscard]] std::uintmax_t parts() const { return size_ / partSize_ + 1; } ///< about so many

    /// Half a megabyte; less of a small text, so that all cores have a part of it and little of it lies in memory twice.
    [[nodiscard]] static std::size_t usualSize(std::uintmax_t textSize);

private:
    struct File;
    TextParts(std::unique_ptr<File> file, std::uintmax_t size, std::size_t partSize);
    [[nodiscard]] Result<std::string_view> nextOfFile(Buffer& buffer);

    std::string_view text_; ///< what is left of a text at hand
    std::unique_ptr<File> file_;
    std::uintmax_t size_ = 0;
    std::size_t partSize_;
};

} // namespace reflectance
