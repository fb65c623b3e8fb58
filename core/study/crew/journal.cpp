#include "core/study/crew/journal.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

Error notWritable(const std::string& path)
{
    return {"cannot be written (" + std::string(std::strerror(errno)) + "); choose another place", path};
}

/// What an earlier run left, as far as it is whole.
struct Found {
    std::uintmax_t bytes = 0; ///< of whole lines
    std::uint64_t lines = 0;
    bool hasHead = false;
};

Result<Found> earlierLines(const std::string& path, const Journal::Form& form)
{
    Found found;
    std::ifstream file(path, std::ios::binary);
    std::string line;
    while (std::getline(file, line) && !file.eof()) { // eof: a line without its end was torn
        if (!found.hasHead) {
            if (line + "\n" != form.head)
                return Error{form.foreign, path};
            found.hasHead = true;
        } else {
            if (!form.isOurs(found.lines, line))
                return Error{form.foreign, path, static_cast<long>(found.lines) + 2};
            ++found.lines;
        }
        found.bytes += line.size() + 1;
    }
    if (!found.hasHead && !line.empty() && !form.head.starts_with(line))
        return Error{form.foreign, path}; // not a torn head, but somebody's file
    return found;
}

} // namespace

Result<Journal> Journal::open(const std::string& path, const Form& form)
{
    std::error_code ignored;
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        return Error{"is not a file but a folder, device or pipe; name a file", path};
    Journal journal(path);
    journal.file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (journal.file_ < 0)
        return notWritable(path);
    if (::flock(journal.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return Error{"is being written by another run; wait for it, or name another file", path};
    const auto found = earlierLines(path, form); // after the lock: nobody else writes
    if (!found)
        return found.error();
    if (::ftruncate(journal.file_, static_cast<off_t>(found->bytes)) != 0)
        return notWritable(path);
    journal.lines_ = found->lines;
    if (!found->hasHead)
        if (const auto written = journal.write(form.head); !written)
            return written.error();
    return journal;
}

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), lines_(other.lines_)
{
}

Journal& Journal::operator=(Journal&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    std::swap(lines_, other.lines_);
    return *this;
}

Journal::~Journal()
{
    if (file_ >= 0)
        ::close(file_);
}

Result<void> Journal::write(const std::string& line) const
{
    const ssize_t written = ::write(file_, line.data(), line.size());
    if (written != static_cast<ssize_t>(line.size())) {
        if (written >= 0) // a full disk takes the beginning; the next run drops it
            errno = ENOSPC;
        return notWritable(path_);
    }
    return {};
}

Result<void> Journal::append(const std::string& line)
{
    if (auto written = write(line); !written)
        return written;
    ++lines_;
    return {};
}

} // namespace reflectance
