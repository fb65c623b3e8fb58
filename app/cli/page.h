// A page for people, with its drawings in the folder images beside it.
#pragma once

#include "core/base/result.h"
#include "core/chart/drawing.h"

#include <functional>

namespace reflectance::cli {

/// Writes the drawings as images/PAGE-NAME.svg, then the page: `textWith` is told what links begin with, "images/PAGE-".
[[nodiscard]] Result<void> writePage(const std::string& path, const std::vector<Drawing>& drawings,
                                     const std::function<std::string(const std::string& images)>& textWith);

} // namespace reflectance::cli
