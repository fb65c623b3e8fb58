// Writes the elements of an <svg>; text is escaped, numbers are rounded to hundredths of a pixel.
#pragma once

#include "core/chart/chart.h"

#include <string>
#include <string_view>

namespace reflectance {

class SvgWriter {
public:
    SvgWriter(int width, int height);

    struct Stroke {
        ChartColor color = 0x404040;
        double width = 1.0;
        double opacity = 1.0;
        bool dashed = false;
    };
    enum class Anchor { Start, Middle, End };

    void line(double x1, double y1, double x2, double y2, const Stroke& stroke);
    void path(const std::string& commands, const Stroke& stroke);
    void area(const std::string& commands, ChartColor fill, const Stroke& rim);            ///< closed and filled
    void image(double x, double y, double width, double height, std::string_view dataUri); ///< each pixel a square
    void circle(double x, double y, double radius, const Stroke& stroke);
    void dot(double x, double y, double radius, ChartColor color, double opacity);
    void rectangle(double x, double y, double width, double height, ChartColor color);
    void hatched(double x, double y, double width, double height); ///< what is unknown
    void text(double x, double y, std::string_view text, Anchor anchor, int size = 12, ChartColor color = 0x303030,
              double turn = 0.0);
    void clipTo(double x, double y, double width, double height); ///< all that follows, until endClip
    void endClip();

    [[nodiscard]] std::string finished();

private:
    std::string out_;
};

/// "M1 2L3 4": appends a point to path commands, starting anew where `begin`.
void appendPoint(std::string& commands, double x, double y, bool begin);

} // namespace reflectance
