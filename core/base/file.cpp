#include "core/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path, int problem)
{
    return {"cannot be written (" + std::string(std::strerror(problem)) + "); choose another place", path};
}

/// 0, or the errno of the first write that failed.
int writeAll(int file, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Creates `path` with the bytes; 0 or errno. `flags` says whether it may exist already.
int writeInto(const std::string& path, std::string_view bytes, int flags, bool wait)
{
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    if (file < 0)
        return errno;
    int problem = writeAll(file, bytes);
    if (problem == 0 && wait && ::fsync(file) != 0)
        problem = errno;
    if (::close(file) != 0 && problem == 0)
        problem = errno;
    return problem;
}

/// Never opens what is no regular file: a pipe would block.
Result<std::uintmax_t> regularFileSize(const std::string& path)
{
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (status.type() == fs::file_type::not_found)
        return Error{"there is no such file", path};
    if (problem)
        return Error{"cannot be read (" + problem.message() + ")", path};
    if (!fs::is_regular_file(status))
        return Error{"is not a file but a folder, device or pipe", path};
    const std::uintmax_t size = fs::file_size(path, problem);
    if (problem)
        return Error{"cannot be read (" + problem.message() + ")", path};
    return size;
}

Result<std::string> firstBytes(const std::string& path, std::size_t count)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{"cannot be opened for reading; check its permissions", path};
    std::string bytes(count, '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(count)))
        return Error{"could not be read to its end", path};
    return bytes;
}

} // namespace

Result<std::string> readWholeFile(const std::string& path, std::uintmax_t limit)
{
    const auto size = regularFileSize(path);
    if (!size)
        return size.error();
    if (*size > limit)
        return Error{"is larger than " + std::to_string(limit >> 20U) + " MiB, the most that is read", path};
    return firstBytes(path, static_cast<std::size_t>(*size));
}

Result<FileHead> readFileHead(const std::string& path, std::size_t most)
{
    const auto size = regularFileSize(path);
    if (!size)
        return size.error();
    auto bytes = firstBytes(path, static_cast<std::size_t>(std::min<std::uintmax_t>(*size, most)));
    if (!bytes)
        return bytes.error();
    return FileHead{*size, *std::move(bytes)};
}

Result<void> writeAtomically(const std::string& path, std::string_view bytes)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        const int problem = fs::is_directory(status) ? EISDIR : writeInto(path, bytes, 0, false);
        return problem == 0 ? Result<void>() : unwritable(path, problem);
    }
    const std::string target =
        fs::is_symlink(fs::symlink_status(path, ignored)) ? fs::weakly_canonical(path, ignored).string() : path;
    const std::string temporary = target + "." + std::to_string(::getpid()) + ".tmp";
    int problem = writeInto(temporary, bytes, O_CREAT | O_TRUNC, true);
    if (problem == 0 && std::rename(temporary.c_str(), target.c_str()) != 0)
        problem = errno;
    if (problem == 0)
        return {};
    ::unlink(temporary.c_str());
    return unwritable(path, problem);
}

Result<void> checkWritable(const std::string& path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        return unwritable(path, EISDIR);
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        return {}; // a device is written directly
    const fs::path folder = fs::path(path).parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
        return unwritable(path, errno);
    return {};
}

} // namespace reflectance
