// The bytes of a file that a user named, once it is certain that reading them ends.
#pragma once

#include "core/base/result.h"

#include <atomic>
#include <memory>
#include <string_view>

namespace reflectance {

class FileBytes {
public:
    FileBytes(std::unique_ptr<char[]> bytes, std::size_t size) : bytes_(std::move(bytes)), size_(size) {}
    [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }

private:
    std::unique_ptr<char[]> bytes_;
    std::size_t size_;
};

/// Regular files only, up to `limit` bytes: no folder, pipe or device, which would block or never end.
Result<FileBytes> fileBytes(const std::string& path, std::size_t limit);

} // namespace reflectance
