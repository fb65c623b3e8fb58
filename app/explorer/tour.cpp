#include "app/explorer/tour.h"

#include "core/base/embedded.h"
#include "core/measured/resample.h"
#include "core/reflectance/evaluate.h"
#include "core/scene/scene_json.h"
#include "core/sensor/sensor.h"
#include "core/study/tables/sample_model.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace reflectance {

std::span<const EmbeddedFile> tourFiles();

namespace explorer {
namespace {

constexpr NamedValue<int> channelNames[] = {{"r", 0}, {"g", 1}, {"b", 2}};
constexpr NamedValue<int> precisionNames[] = {{"double", 0}, {"float", 1}, {"simd", 2}};
constexpr Precision precisions[] = {Precision::Double, Precision::Float, Precision::Simd};
constexpr double inf = std::numeric_limits<double>::infinity();

void readMeasure(ObjectReader object, Measure& measure)
{
    object.read("model", measure.model);
    object.readTexts("set", measure.assignments);
    object.read("theta_i", measure.thetaI, -180.0, 180.0);
    object.read("theta_r", measure.thetaR, -90.0, 90.0);
    object.read("light", measure.light, 0.0);
    object.read("radius", measure.radius, 0.0, 90.0);
    object.readNamed("channel", channelNames, measure.channel);
    object.readNamed("precision", precisionNames, measure.precision);
    object.read("table", measure.fromTable);
    object.read("code", measure.asCode);
    object.read("exposure", measure.exposure, -16.0, 16.0);
    object.finish();
}

void readClaim(ObjectReader object, Claim& claim)
{
    object.read("says", claim.says);
    object.readObject("measure", [&](ObjectReader part) { readMeasure(std::move(part), claim.measure); });
    object.readObject("against", [&](ObjectReader part) { readMeasure(std::move(part), claim.against.emplace()); });
    double is = std::numeric_limits<double>::quiet_NaN(), within = 0.0;
    object.read("is", is);
    object.read("within", within, 0.0);
    claim.low = is - within;
    claim.high = is + within;
    if (std::isnan(is)) {
        claim.low = -inf;
        claim.high = inf;
        object.read("at_least", claim.low);
        object.read("at_most", claim.high);
        if (claim.low == -inf && claim.high == inf)
            object.fail("the claim '" + claim.says + "' has no 'is', 'at_least' or 'at_most'");
    }
    object.finish();
}

void readPrediction(ObjectReader object, TourStep& step)
{
    object.read("question", step.question);
    object.readTexts("choices", step.choices);
    object.read("right", step.right, 1, static_cast<int>(std::max<std::size_t>(1, step.choices.size())));
    object.read("answer", step.answer);
    object.finish();
}

/// B becomes a table of itself.
void readTableOf(ObjectReader object, TourStep& step)
{
    int thetas = 10, phis = 19;
    object.read("thetas", thetas, 2, 181);
    object.read("phis", phis, 2, 361);
    object.finish();
    if (!step.scene.other)
        return object.fail("table_of needs a scene with 'compare'");
    const Scene b = variantB(step.scene);
    SampledModel made = sampledModel(modelOf(b), valuesOf(b),
                                     isotropicShape(static_cast<std::size_t>(thetas), static_cast<std::size_t>(phis)),
                                     Interpolation::Linear, 9);
    made.table.provenance.name = std::string(modelOf(b).id()) + ", sampled";
    step.table = measuredTable(std::move(made.table));
    step.scene.other->model = "table";
    step.scene.other->table = step.table;
}

void readStep(ObjectReader object, TourStep& step)
{
    object.readVersion("reflectance.tour", 1);
    object.read("title", step.title);
    object.readTexts("text", step.text);
    object.read("try", step.task);
    object.readObject("predict", [&](ObjectReader part) { readPrediction(std::move(part), step); });
    object.readObject("scene", [&](ObjectReader part) { readScene(std::move(part), step.scene, {}); });
    object.readObject("table_of", [&](ObjectReader part) { readTableOf(std::move(part), step); });
    object.readList("claims", step.claims, readClaim);
    object.finish();
}

Vec3d inPlane(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::sin(angle), 0.0, std::cos(angle)};
}

Result<double> valueOf(const Measure& measure, const TourStep& step)
{
    Surface surface;
    surface.model = measure.fromTable ? "table" : measure.model;
    if (const auto known = findModel(measure.model); !known)
        return known.error();
    for (const std::string& assignment : measure.assignments)
        if (const auto set = setParameter((*findModel(measure.model))->text, assignment, surface.values); !set)
            return set.error();
    const Observation row{
        {0, 0, 1}, inPlane(measure.thetaR), {{inPlane(-measure.thetaI), measure.light, measure.radius}}};
    const Model& model = modelOf(surface);
    const Vec3d seen = evaluate(model, flatValues(model.text, surface.values), std::span(&row, 1),
                                precisions[measure.precision], lookUpsIn(step.table.get()))[0];
    const double value = measure.channel == 0 ? seen.x : measure.channel == 1 ? seen.y : seen.z;
    if (!measure.asCode)
        return value;
    Image pixel(1, 1);
    pixel.rgb.assign(3, static_cast<float>(value));
    return static_cast<double>(develop(pixel, Sensor{measure.exposure}).rgb[0]);
}

} // namespace

int tourLength()
{
    return static_cast<int>(tourFiles().size());
}

Result<TourStep> parseTourStep(std::string_view text, const std::string& file)
{
    const auto json = parsedJson(text, "a step of the tour in JSON", file);
    if (!json)
        return json.error();
    TourStep step;
    step.scene = defaultScene();
    std::optional<std::string> problem;
    readStep(ObjectReader(*json, "step", problem), step);
    if (problem)
        return Error{*problem, file};
    return step;
}

Result<TourStep> tourStep(int number)
{
    if (number < 1 || number > tourLength())
        return Error{"the tour has steps 1 .. " + std::to_string(tourLength()) + ", not " + std::to_string(number)};
    const EmbeddedFile& file = tourFiles()[static_cast<std::size_t>(number - 1)];
    return parseTourStep(file.bytes, std::string(file.name));
}

Result<double> measured(const Claim& claim, const TourStep& step)
{
    auto value = valueOf(claim.measure, step);
    if (!value || !claim.against)
        return value;
    const auto unit = valueOf(*claim.against, step);
    return unit ? Result<double>(*value / *unit) : unit;
}

bool holds(const Claim& claim, double value)
{
    return value >= claim.low && value <= claim.high;
}

} // namespace explorer
} // namespace reflectance
