// A chart as a value: what is drawn in the window, in a report and in a page is the same numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace reflectance {

enum class AxisScale { Linear, Log };

struct Axis {
    std::string label; ///< with its unit: "theta_r (degrees)"
    double low = 0.0, high = 1.0;
    AxisScale scale = AxisScale::Linear;
    double step = 0.0; ///< between ticks where it is more natural than 1, 2 or 5: 30 degrees; 0: none
};

/// 0xRRGGBB.
using ChartColor = std::uint32_t;

/// Colours that the colour-blind tell apart (Okabe and Ito 2008, without black), legible on white and on dark grey.
[[nodiscard]] ChartColor seriesColor(std::size_t index);

enum class Mark { Line, Dots, LineAndDots };

struct Series {
    std::string name; ///< in the legend; empty: not listed there
    ChartColor color = 0;
    std::vector<double> x, y;        ///< as many of both; what is not finite interrupts the line
    std::vector<double> spread = {}; ///< half the length of an error bar in y, for each point; empty: none
    Mark mark = Mark::Line;
    bool faint = false;                   ///< drawn behind and pale: dominated, unselected
    bool dashed = false;                  ///< what is a reference rather than a result
    std::vector<std::string> labels = {}; ///< beside the points; empty: none
    std::vector<double> spreadX = {};     ///< as `spread`, in x
};

/// A line across the chart.
struct Guide {
    double at = 0.0;
    bool vertical = false;
    std::string label;
};

struct Chart {
    std::string title = {};
    Axis x, y;
    std::vector<Series> series;
    std::vector<Guide> guides;
};

/// Curves about a point: angle in radians from straight up, positive to the right, and radius >= 0.
struct PolarChart {
    struct Curve {
        std::string name;
        ChartColor color = 0;
        std::vector<double> angle, radius;
        bool faint = false;
        std::vector<double> spread =
            {}; ///< half the length of an error bar along the radius, for each point; empty: none
    };
    std::string title = {};
    std::string radiusLabel; ///< what the rings count
    double largest = 1.0;    ///< radius of the rim
    std::vector<Curve> curves;
    std::vector<double> rays; ///< angles of lines from the centre to the rim: L, R
    std::vector<std::string> rayNames;
};

/// Where a value stands on an axis: 0 at its low end, 1 at its high end; beyond them outside 0 .. 1. On a logarithmic axis
/// what is not above 0 is NaN.
[[nodiscard]] double shareAlong(const Axis& axis, double value);

/// The value at a share of the axis; the inverse of shareAlong.
[[nodiscard]] double valueAlong(const Axis& axis, double share);

/// The axis widened to hold every finite number, with a margin of 1/20 of its length at each end; an axis without length
/// gets one. `log` axes leave out what is not above 0.
[[nodiscard]] Axis axisAround(std::string label, const std::vector<double>& numbers,
                              AxisScale scale = AxisScale::Linear);

struct Tick {
    double value = 0.0;
    std::string text;
};

/// Round numbers within the axis, at most `most` of them (and at most 2 where fewer are asked for; at least one): steps of 1, 2 or 5 times a
/// power of ten; on a logarithmic axis powers of ten, or 1, 2 and 5 times them where there is room.
[[nodiscard]] std::vector<Tick> ticksOf(const Axis& axis, int most);

/// A self-contained <svg> element, dark on white; text as text.
[[nodiscard]] std::string svgOf(const Chart& chart, int width, int height);
[[nodiscard]] std::string svgOf(const PolarChart& chart, int width, int height);

/// "series,x,y,spread" and a line per point; numbers read back to the same double.
[[nodiscard]] std::string csvOf(const Chart& chart);
/// "series,angle,radius"
[[nodiscard]] std::string csvOf(const PolarChart& chart);

} // namespace reflectance
