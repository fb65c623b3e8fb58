// Where the project's papers point to.
#pragma once

#include "tests/project/tree.h"

namespace reflectance::project {

/// One sentence per link to a file or heading that is not there. Links to other sites are not followed.
[[nodiscard]] std::vector<std::string> brokenLinks(const SourceFile& paper);

/// One sentence per path in backticks ("core/base/text.h") that does not exist. Patterns and placeholders are left out.
[[nodiscard]] std::vector<std::string> missingPaths(const SourceFile& paper);

} // namespace reflectance::project
