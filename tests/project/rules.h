// Which room may include what: the two tables of docs/architecture.md, and the includes that break them.
#pragma once

#include "tests/project/tree.h"

#include <map>
#include <set>

namespace reflectance::project {

struct Rules {
    std::map<std::string, std::set<std::string>> rooms; ///< room -> rooms it may include, directly or through others
    std::map<std::string, std::set<std::string>> libraries; ///< beginning of a header's name -> folders that may use it
};

/// Reads the tables headed "| room |" and "| headers |".
[[nodiscard]] Rules parseRules(std::string_view architecture);

/// The innermost room that a file belongs to; empty if none.
[[nodiscard]] std::string roomOf(const Rules& rules, std::string_view path);

/// One sentence per include that the rules forbid, with file and line.
[[nodiscard]] std::vector<std::string> forbiddenIncludes(const Rules& rules, const SourceFile& file);

/// A room that may include itself by way of others; empty if there is none.
[[nodiscard]] std::string roomInCircle(const Rules& rules);

} // namespace reflectance::project
