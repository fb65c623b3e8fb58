#include "app/explorer/plot_study.h"

#include "app/explorer/state.h"
#include "core/geometry/camera.h"
#include "core/math/angle.h"
#include "core/study/plots/albedo_chart.h"
#include "core/study/plots/lobes.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr int ballSize = 128;

const Light* selectedLight(const ExplorerState& state)
{
    const auto& lights = state.scene.lights;
    const auto index = static_cast<std::size_t>(state.selectedLight);
    return state.selectedLight >= 0 && index < lights.size() ? &lights[index] : nullptr;
}

/// The point that the curves are about: the one that is probed, else one at the origin that faces the viewer.
struct Stand {
    Vec3d P, N;
};

Stand standOf(const ExplorerState& state)
{
    if (state.probe.looks(state.scene)) {
        const auto& picked = state.probe.picked;
        const auto point =
            picked ? pointIn(state.scene.pins[*picked], state.scene, {1, 1}) : std::optional(state.probe.loose->point);
        if (point)
            return {point->P, point->N};
    }
    return {{}, frameOf(state.scene.camera).back};
}

Vec3d directionTo(const Light& light, const Vec3d& P)
{
    return normalized(light.kind == LightKind::Point ? light.position - P : light.direction);
}

/// The model with this id for the surface: its own, or one of the catalogue.
const Model* modelFor(const std::string& id, const Surface& surface)
{
    if (surface.own && surface.own->id() == id)
        return surface.own.get();
    const auto found = findModel(id);
    return found ? *found : nullptr;
}

PlottedSurface plotted(const Model& model, const Surface& surface, std::size_t index)
{
    return {{model.text.name, seriesColor(index), &model, flatValues(model.text, surface.values),
             lookUpsIn(surface.table.get())},
            surface.own,
            surface.table};
}

bool sameSettings(const CurveSettings& a, const CurveSettings& b)
{
    return a.thetaI == b.thetaI && a.quantity == b.quantity && a.shown == b.shown && a.scale == b.scale;
}

} // namespace

bool operator==(const PlottedSurface& a, const PlottedSurface& b)
{
    return a.named.model == b.named.model && a.named.name == b.named.name && a.named.color == b.named.color &&
           a.named.values == b.named.values && a.own == b.own && a.table == b.table;
}

bool operator==(const PlotQuestion& a, const PlotQuestion& b)
{
    return a.tab == b.tab && sameSettings(a.settings, b.settings) && a.deltaPhi == b.deltaPhi && a.lights == b.lights &&
           a.sensor == b.sensor && a.parameter == b.parameter && a.steps == b.steps && a.surfaces == b.surfaces;
}

std::vector<PlottedSurface> plottedSurfaces(const ExplorerState& state)
{
    const Surface& surface = state.scene.surface;
    std::vector<PlottedSurface> surfaces{plotted(modelOf(surface), surface, 0)};
    if (state.compare.on && state.scene.other) {
        surfaces.front().named.name = "A: " + surfaces.front().named.name;
        surfaces.push_back(plotted(modelOf(*state.scene.other), *state.scene.other, 1));
        surfaces.back().named.name = "B: " + surfaces.back().named.name;
    }
    for (const std::string& id : state.curves.overlays)
        if (const Model* model = modelFor(id, surface); model && model != &modelOf(surface))
            surfaces.push_back(plotted(*model, surface, surfaces.size()));
    return surfaces;
}

std::vector<NamedSurface> named(const std::vector<PlottedSurface>& surfaces)
{
    std::vector<NamedSurface> all;
    for (const PlottedSurface& surface : surfaces)
        all.push_back(surface.named);
    return all;
}

PlotQuestion questionOf(const ExplorerState& state)
{
    const CurvesPage& page = state.curves;
    PlotQuestion question;
    question.tab = page.tab;
    question.surfaces = plottedSurfaces(state);
    if (page.tab == PlotTab::Wedge || page.tab == PlotTab::Map) // of the current surface alone
        question.surfaces.resize(1);
    if (page.tab == PlotTab::Balls || page.tab == PlotTab::Wedge) {
        question.lights = ballLights(shownScene(state));
        question.sensor = state.scene.sensor;
    } else {
        question.settings = page.settings;
        if (page.tab == PlotTab::Map || page.tab == PlotTab::Albedo)
            question.settings.thetaI = 0.0; // it is an axis
    }
    if (page.tab == PlotTab::Map)
        question.deltaPhi = page.deltaPhi;
    if (page.tab == PlotTab::Wedge) {
        const Parameter* parameter = wedgeParameter(page, question.surfaces.front().named.model->text);
        question.parameter = parameter ? parameter->name : "";
        question.steps = page.steps;
    }
    return question;
}

std::optional<PlotAnswer> answered(const PlotQuestion& question, Progress& progress)
{
    PlotAnswer answer{question, {}, {}, {}, {}};
    const std::vector<NamedSurface> surfaces = named(question.surfaces);
    const auto take = [](auto made, auto& to) {
        if (made)
            to = *std::move(made);
        return made.has_value();
    };
    const auto balls = [&](const std::vector<NamedSurface>& of, const std::string& title) {
        const bool made = take(ballsOf(of, question.lights, question.sensor, ballSize, progress), answer.balls);
        answer.balls.title = title;
        return made;
    };
    bool whole = true;
    switch (question.tab) {
    case PlotTab::Curves:
    case PlotTab::Polar:
        break;
    case PlotTab::Lobe:
        whole = take(lobesOf(surfaces, question.settings, progress), answer.lobes);
        break;
    case PlotTab::Balls:
        whole = balls(surfaces, "Lit as the scene is");
        break;
    case PlotTab::Albedo:
        whole = take(albedoOver(surfaces, question.settings.shown, progress), answer.albedo);
        break;
    case PlotTab::Wedge:
        if (const Parameter* parameter = surfaces.front().model->text.find(question.parameter))
            whole = balls(wedgeOf(surfaces.front(), *parameter, question.steps),
                          surfaces.front().name + ": " + parameter->label);
        break;
    case PlotTab::Map:
        whole = take(modelMap(surfaces.front(), question.settings, question.deltaPhi, progress), answer.map);
        break;
    }
    return whole ? std::optional(std::move(answer)) : std::nullopt;
}

const Parameter* wedgeParameter(const CurvesPage& page, const ModelText& model)
{
    const std::vector<const Parameter*> all = wedgeParameters(model);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Parameter* one) { return one->name == page.parameter; });
    return found != all.end() ? *found : all.empty() ? nullptr : all.front();
}

std::optional<double> lightAngle(const ExplorerState& state)
{
    const Light* light = selectedLight(state);
    if (!light)
        return std::nullopt;
    const auto [P, N] = standOf(state);
    const Vec3d L = directionTo(*light, P);
    return degrees(std::atan2(length(cross(N, L)), dot(N, L)));
}

void setLightAngle(ExplorerState& state, double degrees)
{
    const Light* selected = selectedLight(state);
    if (!selected)
        return;
    Light& light = state.scene.lights[static_cast<std::size_t>(state.selectedLight)];
    const auto [P, N] = standOf(state);
    const Vec3d L = directionTo(light, P);
    // Near the normal what is left beside it is rounding, and points anywhere.
    const Vec3d beside = L - dot(L, N) * N;
    const Vec3d right = frameOf(state.scene.camera).right;
    const Vec3d aside = normalized(length(beside) > 1e-3 ? beside : right - dot(right, N) * N);
    const Vec3d moved = std::cos(radians(degrees)) * N + std::sin(radians(degrees)) * aside;
    light.direction = moved;
    light.position = P + length(light.position - P) * moved;
}

std::vector<BallLight> ballLights(const Scene& scene)
{
    const CameraFrame frame = frameOf(scene.camera);
    std::vector<BallLight> lights;
    for (const Light& light : shiningLights(scene)) {
        const Arrival arrival = arrivalAt(light, {0, 0, 0});
        lights.push_back({{dot(arrival.L, frame.right), dot(arrival.L, frame.up), dot(arrival.L, frame.back)},
                          arrival.I,
                          light.angularRadius});
    }
    return lights;
}

} // namespace reflectance::explorer
