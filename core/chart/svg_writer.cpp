#include "core/chart/svg_writer.h"

#include <cmath>
#include <cstdio>

namespace reflectance {
namespace {

std::string pixel(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.2f", std::isfinite(value) ? value : 0.0);
    std::string shortened = text;
    while (shortened.back() == '0')
        shortened.pop_back();
    if (shortened.back() == '.')
        shortened.pop_back();
    return shortened == "-0" ? "0" : shortened;
}

std::string hex(ChartColor color)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(color & 0xFFFFFF));
    return text;
}

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text)
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    return out;
}

std::string strokeText(const SvgWriter::Stroke& stroke)
{
    std::string text = " stroke=\"" + hex(stroke.color) + "\" stroke-width=\"" + pixel(stroke.width) + "\"";
    if (stroke.opacity < 1.0)
        text += " stroke-opacity=\"" + pixel(stroke.opacity) + "\"";
    if (stroke.dashed)
        text += " stroke-dasharray=\"5 4\"";
    return text;
}

} // namespace

SvgWriter::SvgWriter(int width, int height)
{
    const std::string w = std::to_string(width);
    const std::string h = std::to_string(height);
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w +
           " " + h + "\" font-family=\"Inter, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void SvgWriter::line(double x1, double y1, double x2, double y2, const Stroke& stroke)
{
    out_ += "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) + "\" y2=\"" + pixel(y2) +
            "\"" + strokeText(stroke) + "/>\n";
}

void SvgWriter::path(const std::string& commands, const Stroke& stroke)
{
    if (!commands.empty())
        out_ += "<path d=\"" + commands + "\" fill=\"none\" stroke-linejoin=\"round\"" + strokeText(stroke) + "/>\n";
}

void SvgWriter::area(const std::string& commands, ChartColor fill, const Stroke& rim)
{
    out_ +=
        "<path d=\"" + commands + "Z\" fill=\"" + hex(fill) + "\" stroke-linejoin=\"round\"" + strokeText(rim) + "/>\n";
}

void SvgWriter::image(double x, double y, double width, double height, std::string_view dataUri)
{
    out_ += "<image x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" width=\"" + pixel(width) + "\" height=\"" +
            pixel(height) + "\" style=\"image-rendering:pixelated\" href=\"" + std::string(dataUri) + "\"/>\n";
}

void SvgWriter::circle(double x, double y, double radius, const Stroke& stroke)
{
    out_ += "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"" + pixel(radius) + "\" fill=\"none\"" +
            strokeText(stroke) + "/>\n";
}

void SvgWriter::dot(double x, double y, double radius, ChartColor color, double opacity)
{
    out_ += "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"" + pixel(radius) + "\" fill=\"" + hex(color) +
            "\" fill-opacity=\"" + pixel(opacity) + "\"/>\n";
}

void SvgWriter::rectangle(double x, double y, double width, double height, ChartColor color)
{
    out_ += "<rect x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" width=\"" + pixel(width) + "\" height=\"" +
            pixel(height) + "\" fill=\"" + hex(color) + "\"/>\n";
}

void SvgWriter::hatched(double x, double y, double width, double height)
{
    rectangle(x, y, width, height, 0xECECEC);
    clipTo(x, y, width, height);
    std::string lines;
    // Lines of one family over the whole picture: those of neighbouring rectangles meet.
    constexpr double spacing = 8.0;
    for (double at = std::floor((x + y) / spacing) * spacing; at < x + width + y + height; at += spacing) {
        appendPoint(lines, at - y, y, true);
        appendPoint(lines, at - y - height, y + height, false);
    }
    path(lines, {.color = 0xB0B0B0});
    endClip();
}

void SvgWriter::text(double x, double y, std::string_view text, Anchor anchor, int size, ChartColor color, double turn)
{
    const char* anchors[] = {"start", "middle", "end"};
    out_ += "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" text-anchor=\"" + anchors[static_cast<int>(anchor)] +
            "\" font-size=\"" + std::to_string(size) + "\" fill=\"" + hex(color) + "\"";
    if (turn != 0.0)
        out_ += " transform=\"rotate(" + pixel(turn) + " " + pixel(x) + " " + pixel(y) + ")\"";
    out_ += ">" + escaped(text) + "</text>\n";
}

void SvgWriter::clipTo(double x, double y, double width, double height)
{
    // A nested <svg> clips by itself and needs no id, which would have to be unique in the page around it.
    out_ += "<svg x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" width=\"" + pixel(width) + "\" height=\"" +
            pixel(height) + "\" viewBox=\"" + pixel(x) + " " + pixel(y) + " " + pixel(width) + " " + pixel(height) +
            "\">\n";
}

void SvgWriter::endClip()
{
    out_ += "</svg>\n";
}

std::string SvgWriter::finished()
{
    return std::move(out_) + "</svg>\n";
}

void appendPoint(std::string& commands, double x, double y, bool begin)
{
    commands += (begin ? "M" : "L") + pixel(x) + " " + pixel(y);
}

} // namespace reflectance
