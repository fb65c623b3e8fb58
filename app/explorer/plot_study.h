// What the workbench's page of curves knows: which plot of which surfaces is wanted, and the answers of those that take a
// while, made on another thread.
#pragma once

#include "core/chart/heat_map.h"
#include "core/chart/lobe_chart.h"
#include "core/scene/scene.h"
#include "core/study/curves.h"
#include "core/study/plots/balls.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

struct ExplorerState;

/// In the order of their buttons.
enum class PlotTab { Curves, Polar, Lobe, Balls, Albedo, Wedge, Map };

/// A surface of a plot, with what must live as long as it is looked at.
struct PlottedSurface {
    NamedSurface named;
    std::shared_ptr<const Model> own;
    std::shared_ptr<const MeasuredTable> table;

    friend bool operator==(const PlottedSurface& a, const PlottedSurface& b);
};

struct PlotQuestion {
    PlotTab tab = PlotTab::Curves;
    std::vector<PlottedSurface> surfaces; ///< the current one first
    CurveSettings settings;
    double deltaPhi = 180.0; ///< of the map, degrees
    std::vector<BallLight> lights;
    Sensor sensor;
    std::string parameter; ///< of the wedge
    int steps = 7;

    friend bool operator==(const PlotQuestion& a, const PlotQuestion& b);
};

/// That which the question's tab shows; the others are empty.
struct PlotAnswer {
    PlotQuestion question;
    LobeChart lobes;
    HeatMap map;
    Chart albedo;
    BallStrip balls;
};

struct CurvesPage {
    double thetaI = 40.0;              ///< degrees
    CurveSettings settings;            ///< its thetaI follows
    std::vector<std::string> overlays; ///< ids of models beside the current one
    PlotTab tab = PlotTab::Curves;
    bool linked = false; ///< thetaI is the selected light's, at the probed point or one that faces the viewer
    LobeView view;
    double deltaPhi = 180.0;
    std::string parameter; ///< of the wedge; empty, or unknown to the model: its first
    int steps = 7;

    std::optional<PlotQuestion> wish;      ///< what the page wants to show in this frame, where that takes a while
    std::map<PlotTab, PlotAnswer> answers; ///< the last of each kind
    std::map<PlotTab, unsigned> textures;  ///< of strips of balls
    bool measuring = false;
    double done = 0.0; ///< 0 .. 1
};

/// The current surface first, then B while two are compared, then those laid over it, each with the parameters that the scene
/// keeps for it. The user's own model is among them where its id is.
[[nodiscard]] std::vector<PlottedSurface> plottedSurfaces(const ExplorerState& state);
[[nodiscard]] std::vector<NamedSurface> named(const std::vector<PlottedSurface>& surfaces);

/// What the page asks for in its present state.
[[nodiscard]] PlotQuestion questionOf(const ExplorerState& state);

/// Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<PlotAnswer> answered(const PlotQuestion& question, Progress& progress);

/// The parameter that the wedge varies; null where the model has none that can be.
[[nodiscard]] const Parameter* wedgeParameter(const CurvesPage& page, const ModelText& model);

/// The angle in degrees between N and the selected light at the point that is probed; without one, at a point that faces the
/// viewer. Nothing without a light.
[[nodiscard]] std::optional<double> lightAngle(const ExplorerState& state);

/// Moves the selected light to that angle, in the plane that it is in.
void setLightAngle(ExplorerState& state, double degrees);

/// The scene's lights as the viewer has them.
[[nodiscard]] std::vector<BallLight> ballLights(const Scene& scene);

} // namespace reflectance::explorer
