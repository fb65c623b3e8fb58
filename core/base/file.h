// Whole files in, whole files out: a reader that bounds its memory, a writer that leaves nothing half-written.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace reflectance {

/// The bytes of a regular file. Refuses folders, devices and pipes (they may never end) and files above `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::string& path,
                                                std::uintmax_t limit = std::uintmax_t{4} << 30U);

/// How many bytes a regular file has, and the first `most` of them: to look before all is read. Refuses as above.
struct FileHead {
    std::uintmax_t fileSize = 0;
    std::string bytes;
};
[[nodiscard]] Result<FileHead> readFileHead(const std::string& path, std::size_t most);

/// Writes into a new file of the same folder, waits until it is on disk, then renames it to `path`: readers see the old
/// file or the new one. On failure the old file stays and no other remains. A link is followed; a device such as
/// /dev/null is written directly.
[[nodiscard]] Result<void> writeAtomically(const std::string& path, std::string_view bytes);

/// Whether writeAtomically may succeed: the folder exists and takes files. To ask before long work, not instead of it.
[[nodiscard]] Result<void> checkWritable(const std::string& path);

} // namespace reflectance
