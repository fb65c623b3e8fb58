#include "core/study/grab/width.h"

#include "core/math/angle.h"
#include "core/reflectance/evaluate.h"
#include "core/scene/only_term.h"
#include "core/study/grab/grab.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// The surface's highlight, without what its formula adds to it.
class Highlight {
public:
    explicit Highlight(const Surface& surface) : surface_(surface)
    {
        Scene bare;
        bare.surface = surface;
        if (const auto terms = termsAlone(bare); std::find(terms.begin(), terms.end(), "specular") != terms.end())
            if (auto alone = onlyTerm(bare, "specular"))
                surface_ = std::move(alone->surface);
    }

    void set(const std::string& parameter, double value) { surface_.values[parameter] = {value}; }

    /// Of what it is where N lies half way between L and V.
    [[nodiscard]] std::optional<double> height(const Vec3d& N, const Vec3d& L, const Vec3d& V) const
    {
        const Vec3d H = normalized(L + V);
        const Observation rows[] = {{N, V, {{L, Vec3d(1.0), 0.0}}}, {H, V, {{L, Vec3d(1.0), 0.0}}}};
        const Model& model = modelOf(surface_);
        const auto seen = evaluate(model, flatValues(model.text, surface_.values), rows, Precision::Double,
                                   lookUpsIn(surface_.table.get()));
        const auto sum = [](const Vec3d& v) { return v.x + v.y + v.z; };
        if (!(sum(seen[1]) > 0.0))
            return std::nullopt;
        return dot(N, L) > 0.0 ? std::max(0.0, sum(seen[0]) / sum(seen[1])) : 0.0;
    }

private:
    Surface surface_;
};

/// Heights beside the peak, added up: what grows when the highlight widens. From a thousandth of a degree on, for mirrors almost.
double breadth(const Highlight& highlight)
{
    const double s = std::sqrt(0.5);
    const Vec3d L{s, 0.0, s}, V{-s, 0.0, s};
    double sum = 0.0;
    for (const double tilt : {0.001, 0.01, 0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 30.0}) {
        const double angle = radians(tilt);
        sum += highlight.height({std::sin(angle), 0.0, std::cos(angle)}, L, V).value_or(0.0);
    }
    return sum;
}

/// Another value of the slider, a tenth of its way from this one.
double elsewhere(const Parameter& parameter, double value)
{
    const double low = parameter.sliderMin, high = parameter.sliderMax;
    if (parameter.logarithmic && value > 0.0 && low > 0.0) {
        const double factor = std::pow(high / low, 0.1);
        return value * factor <= std::max(high, value) ? value * factor : value / factor;
    }
    const double step = 0.1 * (high - low);
    return value + step <= high ? value + step : value - step;
}

double valueIn(const Scene& scene, const Parameter& parameter)
{
    return valueOf(parameter, scene.surface.values).front();
}

} // namespace

std::optional<SpotWidth> spotWidthOf(const Scene& scene)
{
    if (spotKindOf(scene) != SpotKind::Mirrored)
        return std::nullopt;
    const double as = breadth(Highlight(scene.surface));
    // Less is the rounding of ten sums.
    double most = 1e-9;
    std::optional<SpotWidth> width;
    for (const Parameter& parameter : modelOf(scene).text.parameters) {
        if (parameter.kind != ParameterKind::Number)
            continue;
        const double value = valueIn(scene, parameter), other = elsewhere(parameter, value);
        Highlight changed(scene.surface);
        changed.set(parameter.name, other);
        const double change = breadth(changed) - as;
        if (std::fabs(change) > most) {
            most = std::fabs(change);
            width = SpotWidth{&parameter, (change > 0.0) == (other > value)};
        }
    }
    return width;
}

std::optional<double> spotHeight(const Scene& scene, const Light& light, const ProbedPoint& point)
{
    if (spotKindOf(scene) != SpotKind::Mirrored)
        return std::nullopt;
    return Highlight(scene.surface)
        .height(point.N, arrivalAt(light, point.P).L, normalized(scene.camera.eye - point.P));
}

double widthWithHeightAt(const Scene& scene, const SpotWidth& width, const Light& light, const ProbedPoint& point,
                         double height)
{
    const Parameter& parameter = *width.parameter;
    const double now = valueIn(scene, parameter);
    const Vec3d L = arrivalAt(light, point.P).L, V = normalized(scene.camera.eye - point.P);
    Highlight highlight(scene.surface);
    const auto wider = [&](double value) {
        highlight.set(parameter.name, value);
        return highlight.height(point.N, L, V).value_or(0.0) > height;
    };
    double low = std::min(parameter.sliderMin, now), high = std::max(parameter.sliderMax, now);
    if (wider(low) == wider(high)) // everywhere too wide, or too narrow
        return wider(low) == width.widens ? low : high;
    const bool byFactors = low > 0.0;
    const bool lowIsWide = wider(low);
    for (int step = 0; step < 100 && low < high; ++step) {
        const double middle = byFactors ? std::sqrt(low) * std::sqrt(high) : 0.5 * (low + high);
        if (!(middle > low) || !(middle < high))
            break;
        (wider(middle) == lowIsWide ? low : high) = middle;
    }
    return byFactors ? std::sqrt(low) * std::sqrt(high) : 0.5 * (low + high);
}

} // namespace reflectance
