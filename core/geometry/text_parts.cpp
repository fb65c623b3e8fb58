#include "core/geometry/text_parts.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace reflectance {
namespace {

constexpr std::string_view lineBreaks = "\r\n";

/// Where the last line of `text` ends that no backslash can continue; 0 where there is none. A CR at the very end does
/// not count: it may be half of a CRLF.
std::size_t lastLineEnd(std::string_view text)
{
    for (std::size_t end = text.size() - (text.ends_with('\r') ? 1 : 0); end > 0;) {
        const std::size_t lineBreak = text.find_last_of(lineBreaks, end - 1);
        if (lineBreak == std::string_view::npos)
            return 0;
        const bool isPair = text[lineBreak] == '\n' && lineBreak > 0 && text[lineBreak - 1] == '\r';
        const std::size_t lineEnd = lineBreak - (isPair ? 1 : 0);
        const std::size_t before = lineEnd == 0 ? std::string_view::npos : text.find_last_of(lineBreaks, lineEnd - 1);
        const std::size_t lineBegin = before == std::string_view::npos ? 0 : before + 1;
        if (text.substr(lineBegin, lineEnd - lineBegin).find('\\') == std::string_view::npos)
            return lineBreak + 1;
        end = lineEnd;
    }
    return 0;
}

void makeRoom(TextParts::Buffer& buffer, std::size_t used, std::size_t wanted)
{
    if (wanted <= buffer.capacity)
        return;
    auto larger = std::make_unique_for_overwrite<char[]>(wanted);
    std::copy_n(buffer.bytes.get(), used, larger.get());
    buffer = {std::move(larger), wanted};
}

} // namespace

struct TextParts::File {
    std::string path;
    int handle = -1;
    std::uintmax_t left = 0; ///< bytes not yet read
    std::string rest;        ///< read, but behind the last part's end

    File(std::string name, int opened, std::uintmax_t size) : path(std::move(name)), handle(opened), left(size) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { ::close(handle); }

    /// False when the file ends too early or cannot be read.
    [[nodiscard]] bool read(char* to, std::size_t count)
    {
        while (count > 0) {
            const ssize_t got = ::read(handle, to, count);
            if (got < 0 && errno == EINTR)
                continue;
            if (got <= 0)
                return false;
            to += got;
            count -= static_cast<std::size_t>(got);
            left -= static_cast<std::uintmax_t>(got);
        }
        return true;
    }
};

std::size_t TextParts::usualSize(std::uintmax_t textSize)
{
    return static_cast<std::size_t>(std::clamp<std::uintmax_t>(textSize / 8, 1U << 15U, 1U << 19U));
}

TextParts::TextParts(std::string_view text, std::size_t partSize)
    : text_(text), size_(text.size()), partSize_(partSize > 0 ? partSize : usualSize(text.size()))
{
}

TextParts::TextParts(std::unique_ptr<File> file, std::uintmax_t size, std::size_t partSize)
    : file_(std::move(file)), size_(size), partSize_(partSize > 0 ? partSize : usualSize(size))
{
}

TextParts::TextParts(TextParts&&) noexcept = default;
TextParts& TextParts::operator=(TextParts&&) noexcept = default;
TextParts::~TextParts() = default;

Result<TextParts> TextParts::ofFile(const std::string& path, std::uintmax_t fileSize, std::size_t partSize)
{
    const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (handle < 0)
        return Error{"cannot be opened for reading; check its permissions", path};
    auto file = std::make_unique<File>(path, handle, fileSize);
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    file->rest.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(fileSize, mark.size())));
    if (!file->read(file->rest.data(), file->rest.size()))
        return Error{"could not be read to its end", path};
    if (file->rest == mark)
        file->rest.clear();
    return TextParts(std::move(file), fileSize, partSize);
}

Result<std::string_view> TextParts::next(Buffer& buffer)
{
    if (file_)
        return nextOfFile(buffer);
    std::size_t end = text_.size();
    for (std::size_t tried = partSize_; tried < text_.size(); tried *= 2)
        if (const std::size_t found = lastLineEnd(text_.substr(0, tried)); found > 0) {
            end = found;
            break;
        }
    const std::string_view part = text_.substr(0, end);
    text_.remove_prefix(end);
    return part;
}

Result<std::string_view> TextParts::nextOfFile(Buffer& buffer)
{
    std::size_t used = file_->rest.size();
    makeRoom(buffer, 0, std::max(used, partSize_));
    std::copy(file_->rest.begin(), file_->rest.end(), buffer.bytes.get());
    file_->rest.clear();
    for (std::size_t wanted = std::max(partSize_, 2 * used);; wanted *= 2) {
        const std::size_t more =
            static_cast<std::size_t>(std::min<std::uintmax_t>(wanted - std::min(wanted, used), file_->left));
        makeRoom(buffer, used, used + more);
        if (!file_->read(buffer.bytes.get() + used, more))
            return Error{"could not be read to its end", file_->path};
        used += more;
        const std::string_view text(buffer.bytes.get(), used);
        const std::size_t end = file_->left == 0 ? used : lastLineEnd(text);
        if (end == 0 && file_->left > 0)
            continue;
        file_->rest = text.substr(end);
        return text.substr(0, end);
    }
}

} // namespace reflectance
