#include "app/explorer/session_slot.h"

#include "core/base/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace reflectance::explorer {

namespace fs = std::filesystem;

/// A try for one slot: either the slot, or why not.
struct Attempt {
    std::optional<SessionSlot> slot;
    int problem = 0; ///< errno; EWOULDBLOCK where another program holds it

    static Attempt at(const fs::path& file);
};

namespace {

constexpr long mostPrograms = 1000;
constexpr std::string_view start = "session-", ending = ".json";

fs::path lockOf(fs::path file)
{
    return file.replace_extension(".lock");
}

/// Whether the descriptor is still the file of that name: its last owner may have removed it in between.
bool isStill(int descriptor, const fs::path& path)
{
    struct stat held {
    }, named{};
    return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
           held.st_dev == named.st_dev;
}

bool isThere(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool isSession(const fs::path& path)
{
    const std::string name = path.filename().string();
    if (name.size() <= start.size() + ending.size() || !name.starts_with(start) || !name.ends_with(ending))
        return false;
    return parseInteger(std::string_view(name).substr(start.size(), name.size() - start.size() - ending.size()))
        .has_value();
}

std::vector<fs::path> filesIn(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code problem;
    for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
        files.push_back(at->path());
    return files;
}

fs::file_time_type changed(const SessionSlot& slot)
{
    std::error_code ignored;
    return fs::last_write_time(slot.file(), ignored);
}

/// What a program that was killed while writing left half-written beside the file.
void removeHalfWritten(const fs::path& file)
{
    const std::string beginning = file.filename().string() + ".";
    for (const fs::path& other : filesIn(file.parent_path())) {
        const std::string name = other.filename().string();
        std::error_code ignored;
        if (name.starts_with(beginning) && name.ends_with(".tmp"))
            fs::remove(other, ignored);
    }
}

} // namespace

Attempt Attempt::at(const fs::path& file)
{
    const fs::path path = lockOf(file);
    const int lock = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock < 0)
        return {std::nullopt, errno};
    int problem = ::flock(lock, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (problem == 0 && !isStill(lock, path))
        problem = EWOULDBLOCK;
    if (problem == 0)
        return {SessionSlot(file, lock), 0};
    ::close(lock);
    return {std::nullopt, problem};
}

Result<SessionSlot> SessionSlot::takeFree(const fs::path& folder)
{
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
        return Error{"the folder cannot be made (" + failed.message() + ")", folder.string()};
    int problem = EWOULDBLOCK;
    for (long n = 1; n <= mostPrograms && problem == EWOULDBLOCK; ++n) {
        const fs::path file = folder / (std::string(start) + std::to_string(n) + std::string(ending));
        Attempt attempt = Attempt::at(file);
        if (attempt.slot && !isThere(file)) {
            removeHalfWritten(file);
            return *std::move(attempt.slot);
        }
        problem = attempt.slot ? EWOULDBLOCK : attempt.problem;
    }
    return Error{"no file can be made here (" + std::string(std::strerror(problem)) + ")", folder.string()};
}

std::vector<SessionSlot> SessionSlot::takeAbandoned(const fs::path& folder)
{
    std::vector<SessionSlot> slots;
    for (const fs::path& file : filesIn(folder)) {
        if (!isSession(file))
            continue;
        Attempt attempt = Attempt::at(file);
        if (attempt.slot && isThere(file))
            slots.push_back(*std::move(attempt.slot));
    }
    for (const SessionSlot& slot : slots)
        removeHalfWritten(slot.file());
    std::sort(slots.begin(), slots.end(),
              [](const SessionSlot& a, const SessionSlot& b) { return changed(a) > changed(b); });
    return slots;
}

SessionSlot::SessionSlot(SessionSlot&& other) noexcept
    : file_(std::move(other.file_)), lock_(std::exchange(other.lock_, -1))
{
}

SessionSlot& SessionSlot::operator=(SessionSlot&& other) noexcept
{
    std::swap(file_, other.file_);
    std::swap(lock_, other.lock_);
    return *this;
}

SessionSlot::~SessionSlot()
{
    if (lock_ < 0)
        return;
    ::unlink(lockOf(file_).c_str()); // before letting go: afterwards it might be another program's
    ::close(lock_);
}

void SessionSlot::removeFile() const
{
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

} // namespace reflectance::explorer
