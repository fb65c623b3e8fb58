// Many surfaces, many models: which model serves which surface, and what it costs.
#pragma once

#include "core/study/fit/fit.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// A model, with its choices made.
struct FittedModel {
    std::string label; ///< "oren_nayar", "koenderink, order 8"
    const Model* model = nullptr;
    ParameterValues fixed;
    double nsDouble = 0.0, nsSimd = 0.0; ///< per evaluation, measured on this machine
};

struct SurveyedSurface {
    std::string name;   ///< file without folder and ending, and its number where the file holds several
    std::string format; ///< "CUReT", "RGL ..."
    std::size_t samples = 0;
    std::vector<std::optional<FitResult>> fits; ///< as many as candidates; nothing where a model cannot be fitted
};

struct Survey {
    FitOptions options;
    std::vector<FittedModel> candidates;
    std::vector<SurveyedSurface> surfaces;
    std::vector<std::string> skipped; ///< files that are no measured surfaces, and fits that failed, in sentences
};

/// How a survey is run.
struct SurveyRun {
    std::string journal =
        {}; ///< a file that keeps every fit as it is done, and from which the next run goes on; empty: none
    unsigned workers = 0; ///< processes in each rank, each with a fit at a time; 0: one per core
    std::shared_ptr<const Model> own = {}; ///< a model of one's own to fit after those of the catalogue
};

/// Every model of the catalogue that can be fitted to a surface without colour, once per choice that it offers, without costs.
[[nodiscard]] std::vector<FittedModel> candidatesOfCatalogue();

/// Fits every candidate to every surface of the files, and of the folders with all they contain, in the order of their names.
/// Surfaces are taken without their colour: the mean of the channels. Refused: a path that is not there, a folder without a
/// measured surface, a named file that is none, an own model without a parameter to fit, a journal of other fits. A fit whose process dies is missing and told among what
/// was left out. In a rank that is not the first this works for the first.
[[nodiscard]] Result<Survey> survey(const std::vector<std::string>& paths, const FitOptions& options,
                                    Progress* progress = nullptr, const SurveyRun& run = {});

/// Index of the candidate with the smallest cost in SIMD lanes whose relative RMS error is within `tolerance`.
[[nodiscard]] std::optional<std::size_t> cheapestWithin(const Survey& survey, const SurveyedSurface& surface,
                                                        double tolerance);

/// Index of the candidate with the lowest BIC.
[[nodiscard]] std::optional<std::size_t> bestByBic(const SurveyedSurface& surface);

/// The question of the lecture: is the surface served by Lambert, only by the hybrid, or by neither?
enum class ServedBy { Lambert, Hybrid, Neither };
[[nodiscard]] ServedBy servedBy(const Survey& survey, const SurveyedSurface& surface, double tolerance);

/// Relative RMS errors of the candidate with this label, one per surface; infinite where it could not be fitted.
[[nodiscard]] std::vector<double> errorsOf(const Survey& survey, const std::string& label);

} // namespace reflectance
