#include "core/study/fit/plane_chart.h"

#include "core/base/text.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reflectance {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double widest = 88.0; ///< degrees of the viewer: at the horizon some models grow without bound
constexpr double modelStep = 0.25, dataStep = 2.0;

/// In the plane of the light, which stands at azimuth 0; positive angles are away from it.
Vec3d viewerAt(double degrees)
{
    return directionAt(std::fabs(degrees) * degree, degrees >= 0.0 ? std::numbers::pi : 0.0);
}

double meanOf(const Vec3d& v)
{
    return (v.x + v.y + v.z) / 3.0;
}

Series measured(const Measurement& measurement, const Vec3d& L, double scale)
{
    Series series{"measured", seriesColor(0), {}, {}, {}, Mark::Dots, false, false, {}};
    for (double angle = -widest; angle <= widest; angle += dataStep) {
        const auto f = brdfAt(measurement, L, viewerAt(angle));
        series.x.push_back(angle);
        series.y.push_back(f ? scale * meanOf(*f * Vec3d(1.0)) : std::numeric_limits<double>::quiet_NaN());
    }
    return series;
}

Series modelled(const Model& model, const std::vector<double>& flat, const Vec3d& L, double scale)
{
    Series series{model.text.name + ", fitted", seriesColor(1), {}, {}, {}, Mark::Line, false, false, {}};
    std::vector<Observation> rows;
    for (double angle = -widest; angle <= widest; angle += modelStep) {
        series.x.push_back(angle);
        rows.push_back({{0.0, 0.0, 1.0}, viewerAt(angle), {{L, Vec3d(1.0)}}});
    }
    for (const Vec3d& value : evaluate(model, flat, rows, Precision::Double))
        series.y.push_back(scale * meanOf(value));
    return series;
}

} // namespace

Chart chartInPlane(const Measurement& measurement, const Model& model, const std::vector<double>& flat, double thetaI,
                   bool cosine)
{
    const Vec3d L = directionAt(thetaI, 0.0);
    Chart chart;
    chart.title = "Light at " + general(thetaI / degree, 3) + " degrees";
    chart.x = {"theta_r (degrees; light on the left)", -90.0, 90.0, AxisScale::Linear};
    chart.series = {measured(measurement, L, std::numbers::pi * (cosine ? L.z : 1.0)),
                    modelled(model, flat, L, cosine ? 1.0 : 1.0 / L.z)};
    std::vector<double> all{0.0};
    for (const Series& series : chart.series)
        all.insert(all.end(), series.y.begin(), series.y.end());
    chart.y = axisAround(cosine ? "pi f cos(theta_i)" : "pi f", all);
    chart.guides = {{thetaI / degree, true, "R"}, {-thetaI / degree, true, "L"}};
    return chart;
}

double usualIncidence(const Measurement& measurement)
{
    double best = 30.0 * degree;
    int most = -1;
    for (const double candidate : {30.0, 45.0, 20.0, 60.0, 10.0, 70.0}) {
        int seen = 0;
        for (double angle = -widest; angle <= widest; angle += dataStep)
            seen += brdfAt(measurement, directionAt(candidate * degree, 0.0), viewerAt(angle)) ? 1 : 0;
        if (seen > most) {
            best = candidate * degree;
            most = seen;
        }
    }
    return best;
}

} // namespace reflectance
