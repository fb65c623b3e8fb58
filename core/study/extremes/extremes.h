// The hazards at which reflectance code breaks, numbered H01 to H74, as data with one runner: what was expected, what
// this very run found, and the verdict, in every arithmetic that a hazard concerns.
#pragma once

#include "core/study/extremes/exhibit.h"
#include "core/study/extremes/instruments.h"

#include <string>
#include <vector>

namespace reflectance {

enum class Verdict {
    Pass,
    Fail,
    NotYet, ///< the model or part that the hazard concerns does not exist in this program: it proves nothing
    NotRun, ///< no OpenGL context opens here
};

/// "pass", "FAIL", "not yet", "not run".
[[nodiscard]] std::string_view nameOf(Verdict verdict);

/// One row of the report.
struct Finding {
    std::size_t hazard = 0; ///< its place in the table
    std::string id;         ///< "H04"
    std::string danger;     ///< what can go wrong
    std::string arithmetic; ///< "double", "float", "simd", "glsl"; "-" where no model computes
    std::string input, expected;
    std::string found; ///< as computed in this run, or why nothing was
    Verdict verdict = Verdict::Fail;
};

/// Every hazard, or the one with this id, in every arithmetic that it concerns. An unknown id gives no findings.
[[nodiscard]] std::vector<Finding> runExtremes(const Instruments& instruments, std::string_view only = {});

/// The case of a finding, to be looked at.
[[nodiscard]] Exhibit exhibitOf(const Finding& finding);

/// The ids, in their order.
[[nodiscard]] std::vector<std::string> hazardIds();

struct ExtremesSummary {
    std::size_t passed = 0, failed = 0, notYet = 0, notRun = 0;
};
[[nodiscard]] ExtremesSummary summaryOf(const std::vector<Finding>& findings);

} // namespace reflectance
