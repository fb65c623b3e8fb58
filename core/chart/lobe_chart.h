// Lobes in space as values: what leaves towards every direction above a surface, as a distance from its point. Drawn as
// polygons from the far to the near, in the window and on paper alike.
#pragma once

#include "core/chart/chart.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace reflectance {

/// Angles in radians: theta from the normal (z), phi from +x, where the light's side is phi = pi. Each lobe has a radius for
/// every pair, theta by theta; what is negative or no number is drawn as 0, what leaves the rim far behind is cut there.
struct LobeChart {
    struct Lobe {
        std::string name;
        ChartColor color = 0;
        std::vector<double> radius;
    };
    struct Ray {
        std::string name;
        double theta = 0.0, phi = 0.0;
    };
    std::string title;
    std::string radiusLabel;        ///< what the radius counts
    double largest = 1.0;           ///< radius of the rim
    std::vector<double> theta, phi; ///< ascending; phi from 0 to 2 pi, both ends
    std::vector<Lobe> lobes;
    std::vector<Ray> rays; ///< L, R

    [[nodiscard]] std::size_t at(std::size_t ring, std::size_t column) const { return ring * phi.size() + column; }
};

/// Whence it is looked at.
struct LobeView {
    double azimuth = -0.6;  ///< radians about the normal
    double elevation = 0.5; ///< radians above the surface, -pi/2 .. pi/2
    bool filled = true;     ///< else a net of lines

    friend bool operator==(const LobeView&, const LobeView&) = default;
};

/// A place in the picture: x to the right, y up, in units of the rim; larger depth is nearer.
struct LobePoint {
    double x = 0.0, y = 0.0, depth = 0.0;
};

/// A direction and a distance in units of the rim.
[[nodiscard]] LobePoint projected(double theta, double phi, double distance, const LobeView& view);

struct LobeFacet {
    std::array<LobePoint, 4> corners;
    std::size_t lobe = 0, ring = 0, column = 0; ///< its first corner's place in the grid
    double light = 1.0;                         ///< 0.35 .. 1: how much its face is turned to the viewer
};

/// The patches between neighbouring directions, from the far to the near.
[[nodiscard]] std::vector<LobeFacet> facetsOf(const LobeChart& chart, const LobeView& view);

/// The nearest patch that holds the place; null where there is none.
[[nodiscard]] const LobeFacet* facetAt(const std::vector<LobeFacet>& facets, double x, double y);

/// A patch's colour: that of its lobe, darker where it is turned away.
[[nodiscard]] ChartColor shadedColor(ChartColor color, double light);

[[nodiscard]] std::string svgOf(const LobeChart& chart, const LobeView& view, int width, int height);

/// "series,theta,phi,radius" and a line for each direction.
[[nodiscard]] std::string csvOf(const LobeChart& chart);

} // namespace reflectance
