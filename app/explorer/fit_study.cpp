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

Result<FitOutcome> gathered(const FitWish& wish, Progress& progress)
{
    FitOutcome outcome;
    outcome.wish = wish;
    if (wish.fromPicture) {
        auto seen = observationsOf(wish.photograph->picture, *wish.scene, wish.pixels, 20000, &progress);
        if (!seen)
            return Error{seen.error().message, wish.photograph->file};
        outcome.observations = *std::move(seen);
        return outcome;
    }
    auto measurement = loadMeasurement(wish.file, {static_cast<std::size_t>(wish.surface), {}});
    if (!measurement)
        return measurement.error();
    outcome.observations = observationsOf(*measurement);
    outcome.measurement = *std::move(measurement);
    return outcome;
}

} // namespace

std::optional<Photograph> photographFrom(const std::string& file, const Sensor& sensor, const Progress& progress)
{
    Photograph photograph;
    photograph.file = file;
    auto picture = readPicture(file);
    if (progress.cancel)
        return std::nullopt;
    if (!picture) {
        photograph.problem = picture.error().sentence();
        return photograph;
    }
    photograph.shown = develop(picture->image, picture->isLinear() ? sensor : Sensor());
    photograph.picture = *std::move(picture);
    return photograph;
}

std::optional<FitOutcome> fittedAsWished(const FitWish& wish, Progress& progress)
{
    const auto model = findModel(wish.model);
    if (!model)
        return refusedFit(wish, model.error());
    auto outcome = gathered(wish, progress);
    if (progress.cancel)
        return std::nullopt;
    if (!outcome)
        return refusedFit(wish, outcome.error());
    auto fit = fitModel(**model, outcome->observations, optionsOf(wish), &progress);
    if (progress.cancel)
        return std::nullopt;
    if (!fit)
        return refusedFit(wish, fit.error());
    outcome->fit = *std::move(fit);
    return *std::move(outcome);
}

} // namespace reflectance::explorer
