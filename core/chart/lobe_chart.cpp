#include "core/chart/lobe_chart.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

using Corners = std::array<LobePoint, 4>;

double distanceOf(double radius, double largest)
{
    constexpr double furthest = 1.15; // of the rim
    return std::isfinite(radius) && radius > 0.0 ? std::min(radius / largest, furthest) : 0.0;
}

/// The cosine between a facet's face and the line of sight, from its diagonals.
double turned(const Corners& c)
{
    const double ax = c[2].x - c[0].x, ay = c[2].y - c[0].y, az = c[2].depth - c[0].depth;
    const double bx = c[3].x - c[1].x, by = c[3].y - c[1].y, bz = c[3].depth - c[1].depth;
    const double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
    const double length = std::sqrt(x * x + y * y + z * z);
    return length > 0.0 ? std::fabs(z) / length : 0.0;
}

double depthOf(const LobeFacet& facet)
{
    double sum = 0.0;
    for (const LobePoint& corner : facet.corners)
        sum += corner.depth;
    return sum;
}

/// Even-odd, so that facets that are folded in the picture count where they cover it.
bool holds(const Corners& c, double x, double y)
{
    bool inside = false;
    for (std::size_t i = 0, j = 3; i < 4; j = i++)
        if ((c[i].y > y) != (c[j].y > y) && x < (c[j].x - c[i].x) * (y - c[i].y) / (c[j].y - c[i].y) + c[i].x)
            inside = !inside;
    return inside;
}

} // namespace

LobePoint projected(double theta, double phi, double distance, const LobeView& view)
{
    const double turn = phi - view.azimuth;
    const double side = distance * std::sin(theta) * std::cos(turn);
    const double away = distance * std::sin(theta) * std::sin(turn);
    const double up = distance * std::cos(theta);
    const double c = std::cos(view.elevation), s = std::sin(view.elevation);
    return {side, c * up + s * away, s * up - c * away};
}

std::vector<LobeFacet> facetsOf(const LobeChart& chart, const LobeView& view)
{
    std::vector<LobeFacet> facets;
    for (std::size_t lobe = 0; lobe < chart.lobes.size(); ++lobe) {
        std::vector<LobePoint> places(chart.theta.size() * chart.phi.size());
        for (std::size_t ring = 0; ring < chart.theta.size(); ++ring)
            for (std::size_t column = 0; column < chart.phi.size(); ++column)
                places[chart.at(ring, column)] =
                    projected(chart.theta[ring], chart.phi[column],
                              distanceOf(chart.lobes[lobe].radius[chart.at(ring, column)], chart.largest), view);
        for (std::size_t ring = 0; ring + 1 < chart.theta.size(); ++ring)
            for (std::size_t column = 0; column + 1 < chart.phi.size(); ++column) {
                LobeFacet facet{{places[chart.at(ring, column)], places[chart.at(ring, column + 1)],
                                 places[chart.at(ring + 1, column + 1)], places[chart.at(ring + 1, column)]},
                                lobe,
                                ring,
                                column};
                facet.light = 0.35 + 0.65 * turned(facet.corners);
                facets.push_back(facet);
            }
    }
    std::stable_sort(facets.begin(), facets.end(),
                     [](const LobeFacet& a, const LobeFacet& b) { return depthOf(a) < depthOf(b); });
    return facets;
}

const LobeFacet* facetAt(const std::vector<LobeFacet>& facets, double x, double y)
{
    const auto found = std::find_if(facets.rbegin(), facets.rend(),
                                    [&](const LobeFacet& facet) { return holds(facet.corners, x, y); });
    return found == facets.rend() ? nullptr : &*found;
}

ChartColor shadedColor(ChartColor color, double light)
{
    ChartColor shaded = 0;
    for (const int shift : {16, 8, 0})
        shaded |= static_cast<ChartColor>(std::lround(light * ((color >> shift) & 0xFFU))) << shift;
    return shaded;
}

} // namespace reflectance
