// Folders as the file browser shows them: what is in one, what a half-typed path means, how it may go on. No drawing.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance::explorer {

struct FolderEntry {
    std::string name;
    bool isFolder = false;
    std::uintmax_t size = 0; ///< bytes; 0 for folders

    friend bool operator==(const FolderEntry&, const FolderEntry&) = default;
};

/// "mesh", "scene", "environment", "measurement" by the ending; "" where the program reads no such file.
[[nodiscard]] std::string_view kindOfFile(std::string_view name);

/// Folders first, then files, by name without regard to case; hidden ones are left out, and other kinds of files too
/// unless `everyFile`. The error is one sentence on a folder that cannot be read.
[[nodiscard]] Result<std::vector<FolderEntry>> listFolder(const std::filesystem::path& folder, bool everyFile);

/// What a typed text means: the folder it leads to, and the beginning of a name in it.
struct TypedPlace {
    std::filesystem::path folder;
    std::string leaf;
};

/// "~" is the home folder; a relative path starts in `folder`.
[[nodiscard]] TypedPlace placeOf(const std::filesystem::path& folder, std::string_view typed);

/// The entries whose name contains the leaf, without regard to case.
[[nodiscard]] std::vector<FolderEntry> matching(std::span<const FolderEntry> entries, std::string_view leaf);

/// The typed text, gone on as far as all names that begin with its leaf agree; a single folder gets its slash.
[[nodiscard]] std::string completed(std::string_view typed, std::span<const FolderEntry> entries);

/// "812 B", "65.2 kB", "7.1 MB".
[[nodiscard]] std::string readableSize(std::uintmax_t bytes);

/// $HOME, or the root folder without one.
[[nodiscard]] std::filesystem::path homeFolder();

} // namespace reflectance::explorer
