#include "core/geometry/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace reflectance {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }

private:
    int number_;
};

const char* kindOf(mode_t mode)
{
    if (S_ISDIR(mode))
        return "a folder";
    if (S_ISFIFO(mode))
        return "a pipe";
    return "a device";
}

std::string megabytes(std::size_t bytes)
{
    return std::to_string(bytes / 1'000'000) + " MB";
}

} // namespace

Result<FileBytes> fileBytes(const std::string& path, std::size_t limit)
{
    // Non-blocking, for opening a pipe would wait for its writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    struct stat status {};
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
        return Error{std::string("cannot be opened (") + std::strerror(errno) + "); check the name and the permissions", path};
    if (!S_ISREG(status.st_mode))
        return Error{std::string("is ") + kindOf(status.st_mode) + ", not a file; name a file", path};
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > limit)
        return Error{"has " + megabytes(size) + ", more than the limit of " + megabytes(limit) + "; simplify or split it", path};

    auto bytes = std::make_unique_for_overwrite<char[]>(size);
    std::size_t got = 0;
    while (got < size) {
        const ssize_t step = ::read(file.number(), bytes.get() + got, size - got);
        if (step < 0 && errno == EINTR)
            continue;
        if (step < 0)
            return Error{std::string("cannot be read (") + std::strerror(errno) + "); check the disk", path};
        if (step == 0)
            break; // shortened while being read: what is there is judged by the reader
        got += static_cast<std::size_t>(step);
    }
    return FileBytes(std::move(bytes), got);
}

} // namespace reflectance
