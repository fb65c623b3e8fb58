// The project's own files, as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::project {

struct SourceFile {
    std::string path; ///< from the project's folder: "core/base/text.h"
    std::string text;
};

/// Files below the given folders whose names have one of the endings, ordered by path.
[[nodiscard]] std::vector<SourceFile> filesBelow(const std::vector<std::string>& folders,
                                                 const std::vector<std::string>& endings);

/// The text of one file of the project, named from its folder; empty if it is not there.
[[nodiscard]] std::string textOf(const std::string& path);

[[nodiscard]] bool exists(const std::string& path);

/// What stands between pairs of backticks.
[[nodiscard]] std::vector<std::string> inBackticks(std::string_view text);

} // namespace reflectance::project
