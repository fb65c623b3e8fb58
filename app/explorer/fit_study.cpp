#include "app/explorer/fit_study.h"

#include "core/measured/load.h"

namespace reflectance::explorer {

namespace {

FitOptions optionsOf(const FitWish& wish)
{
    FitOptions options;
    options.weighting = wish.logarithmic ? Weighting::Logarithmic : Weighting::Linear;
    options.cosine = wish.cosine;
    options.robust = wish.robust;
    return options;
}

FitOutcome refusedFit(const FitWish& wish, const Error& error)
{
    FitOutcome outcome;
    outcome.wish = wish;
    outcome.problem = error.sentence();
    return outcome;
}

} // namespace

std::optional<FitOutcome> fittedAsWished(const FitWish& wish, Progress& progress)
{
    auto measurement = loadMeasurement(wish.file, {static_cast<std::size_t>(wish.surface), {}});
    if (!measurement)
        return refusedFit(wish, measurement.error());
    const auto model = findModel(wish.model);
    if (!model)
        return refusedFit(wish, model.error());
    Observations observations = observationsOf(*measurement);
    auto fit = fitModel(**model, observations, optionsOf(wish), &progress);
    if (progress.cancel)
        return std::nullopt;
    if (!fit)
        return refusedFit(wish, fit.error());
    return FitOutcome{wish, {}, *std::move(measurement), std::move(observations), *std::move(fit)};
}

} // namespace reflectance::explorer
