// A survey as a page for people: the lecture's question, what the numbers answer, and drawings of both.
#pragma once

#include "core/chart/drawing.h"
#include "core/study/fit/survey.h"

#include <string>
#include <vector>

namespace reflectance {

/// How many surfaces each model serves within a tolerance; each surface under Lambert, hybrid and its best model; median error
/// against cost.
[[nodiscard]] std::vector<Drawing> drawingsOf(const Survey& survey, double tolerance);

/// Markdown. Drawings are linked as `images` + name + ".svg".
[[nodiscard]] std::string pageOf(const Survey& survey, double tolerance, const std::string& images);

} // namespace reflectance
