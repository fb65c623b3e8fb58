// The check that Oren and Nayar did on their formula: grooves of Lambert facets, traced, against what the formula says of them.
#pragma once

#include "core/chart/drawing.h"
#include "core/study/goniometer/formula_gap.h"

namespace reflectance {

/// One roughness: grooves of slopes spread by sigma, traced with no, one and many interreflections.
struct StudiedGrooves {
    double sigma = 0.0; ///< degrees
    LabRun once, twice, often;
    FormulaGap onceAgainstFirst, onceAgainstLambert;  ///< single reflection against L1; and against rho cos(theta_i)
    FormulaGap twiceAgainstFull, oftenAgainstFull;    ///< with interreflection against L1 + L2
    FormulaGap onceAgainstSimple, oftenAgainstSimple; ///< the A/B form, which has no interreflection
};

struct GrooveStudy {
    double rho = 0.9;
    LabTargets targets;
    std::vector<StudiedGrooves> grooves;
};

/// Nothing left out but what `progress` stopped: then it is an error.
[[nodiscard]] Result<GrooveStudy> studyGrooves(const std::vector<double>& sigmas, double rho, std::size_t thetas,
                                               const LabTargets& targets, Progress* progress);

[[nodiscard]] std::vector<Drawing> drawingsOf(const GrooveStudy& study);
/// Markdown. Drawings are linked as `images` + name + ".svg"; `command` made the page.
[[nodiscard]] std::string pageOf(const GrooveStudy& study, const std::string& images, const std::string& command);

} // namespace reflectance
