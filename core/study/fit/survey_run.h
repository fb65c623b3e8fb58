// The fits of a survey, each a job of a crew: on all cores or ranks, a failure staying its own, kept as they are done.
#pragma once

#include "core/study/fit/observations.h"
#include "core/study/fit/survey.h"

#include <vector>

namespace reflectance {

/// A surface of a survey with what was measured on it.
struct SurveySubject {
    SurveyedSurface surface;
    Observations data;
};

/// Fits every candidate of `survey` to every subject, and moves the surfaces into it. In a rank that is not the first there is
/// nothing to be had of it.
[[nodiscard]] Result<void> fitAll(Survey& survey, std::vector<SurveySubject> subjects, const SurveyRun& run,
                                  Progress* progress);

} // namespace reflectance
