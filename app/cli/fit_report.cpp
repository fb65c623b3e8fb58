#include "app/cli/fit_report.h"

#include "core/base/text.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

double mirrorDegrees(const Observations& observations)
{
    return nearestMirror(observations) * 180.0 / std::numbers::pi;
}

std::string errorText(const FittedNumber& number)
{
    return number.atBound ? "at its bound"
                          : general(number.standardError, 3) + (number.determined ? "" : "  (not determined)");
}

const char* quantityName(const FitOptions& options)
{
    return options.cosine ? "pi f (N.L)" : "pi f";
}

Json numbersOf(const FitResult& fit)
{
    Json numbers = Json::array();
    for (const FittedNumber& n : fit.numbers)
        numbers.push_back({{"name", n.name},
                           {"value", n.value},
                           {"standard_error", n.atBound ? Json(nullptr) : Json(n.standardError)},
                           {"at_bound", n.atBound},
                           {"determined", n.determined}});
    return numbers;
}

Json rowsOf(const std::vector<double>& matrix, std::size_t width)
{
    Json rows = Json::array();
    for (std::size_t i = 0; i < width; ++i)
        rows.push_back(std::vector<double>(matrix.begin() + static_cast<std::ptrdiff_t>(i * width),
                                           matrix.begin() + static_cast<std::ptrdiff_t>((i + 1) * width)));
    return rows;
}

} // namespace

void print(const Model& model, const Observations& observations, const FitResult& fit, const FitOptions& options)
{
    std::printf("%s: %zu samples with %zu channel%s; the one nearest to the mirror direction is %.3g degrees off\n",
                observations.name.c_str(), observations.rows.size(), observations.channels(),
                observations.channels() == 1 ? "" : "s", mirrorDegrees(observations));
    std::printf("%s: %s weights on %s%s\n\n", model.text.name.c_str(), std::string(nameOf(options.weighting)).c_str(),
                quantityName(options), options.robust ? ", outliers held back" : "");
    std::printf("    %-24s %14s   %s\n", "parameter", "value", "standard error");
    for (const FittedNumber& n : fit.numbers)
        std::printf("    %-24s %14.6g   %s\n", n.name.c_str(), n.value, errorText(n).c_str());
    std::printf("\n    %-24s %14.4g   in %s\n", "RMS error", fit.rms, quantityName(options));
    std::printf("    %-24s %13.3g %%   of the data's own RMS\n", "relative RMS error", 100.0 * fit.relativeRms);
    std::printf("    %-24s %14.6g\n    %-24s %14.6g   lower is better, on the same data and weights\n", "AIC", fit.aic,
                "BIC", fit.bic);
    std::printf("    %-24s %8d of %d   found this minimum\n", "starts", fit.startsThatAgree, fit.startsTried);
    for (const std::string& warning : fit.warnings)
        std::printf("  ! %s\n", warning.c_str());
}

Json described(const Model& model, const Observations& observations, const FitResult& fit, const FitOptions& options)
{
    return {{"surface", observations.name},
            {"samples", observations.rows.size()},
            {"channels", observations.channels()},
            {"nearest_mirror_degrees", mirrorDegrees(observations)},
            {"model", model.id()},
            {"weights", nameOf(options.weighting)},
            {"cosine", options.cosine},
            {"robust", options.robust},
            {"parameters", fit.values},
            {"numbers", numbersOf(fit)},
            {"correlations", rowsOf(fit.correlations, fit.numbers.size())},
            {"rms", fit.rms},
            {"relative_rms", fit.relativeRms},
            {"weighted_rms", fit.weightedRms},
            {"aic", fit.aic},
            {"bic", fit.bic},
            {"residuals", fit.residuals},
            {"starts", fit.startsTried},
            {"starts_that_agree", fit.startsThatAgree},
            {"iterations", fit.iterations},
            {"warnings", fit.warnings}};
}

} // namespace reflectance::cli
