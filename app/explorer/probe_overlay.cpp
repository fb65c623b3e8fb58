#include "app/explorer/probe_overlay.h"

#include "app/explorer/ui/widgets.h"
#include "core/math/angle.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace reflectance::explorer {
namespace {

/// Colours that the colour-blind tell apart (Okabe and Ito 2008), on a dark rim that makes them readable over any picture.
constexpr ImU32 white = IM_COL32(255, 255, 255, 255), yellow = IM_COL32(240, 228, 66, 255),
                blue = IM_COL32(86, 180, 233, 255), orange = IM_COL32(240, 160, 40, 255), rim = IM_COL32(0, 0, 0, 170);
/// Of half the picture's height, at the point's distance: longer than the lobe.
constexpr double arrowShare = 0.52;

struct Pen {
    ImDrawList& canvas;
    const PictureView& view;
    const Camera& camera;

    [[nodiscard]] ImVec2 onScreen(double x, double y) const
    {
        return {view.x + static_cast<float>(x) / view.pixelsPerPoint,
                view.y + static_cast<float>(y) / view.pixelsPerPoint};
    }
    [[nodiscard]] ImVec2 at(const Vec3d& place) const
    {
        const Vec3d image = projected(camera, place, view.size.width, view.size.height);
        return onScreen(image.x, image.y);
    }
    [[nodiscard]] float points(float length) const { return length * view.scale; }

    void line(ImVec2 from, ImVec2 to, ImU32 color, float width) const
    {
        canvas.AddLine(from, to, rim, points(width + 2.0F));
        canvas.AddLine(from, to, color, points(width));
    }
    void polyline(const std::vector<Vec3d>& places, ImU32 color, float width) const
    {
        std::vector<ImVec2> screen;
        for (const Vec3d& place : places)
            screen.push_back(at(place));
        canvas.AddPolyline(screen.data(), static_cast<int>(screen.size()), color, ImDrawFlags_None, points(width));
    }
    void label(ImVec2 middle, ImU32 color, const std::string& text) const
    {
        const ImVec2 size = sizeIn(Face::Strong, text);
        const ImVec2 corner{middle.x - size.x / 2, middle.y - size.y / 2};
        const float pad = points(3);
        canvas.AddRectFilled({corner.x - pad, corner.y}, {corner.x + size.x + pad, corner.y + size.y}, rim, points(4));
        drawText(canvas, Face::Strong, corner, color, text);
    }
};

/// An arrow, its letter beyond the tip. One that points at the eye is a dot in a circle.
void drawArrow(const Pen& pen, const Vec3d& from, const Vec3d& direction, double length, ImU32 color, const char* name)
{
    const ImVec2 foot = pen.at(from), tip = pen.at(from + length * direction);
    const float dx = tip.x - foot.x, dy = tip.y - foot.y;
    const float way = std::hypot(dx, dy);
    if (way < pen.points(14)) {
        pen.canvas.AddCircle(foot, pen.points(9), rim, 24, pen.points(4));
        pen.canvas.AddCircle(foot, pen.points(9), color, 24, pen.points(1.8F));
        pen.canvas.AddCircleFilled(foot, pen.points(2.5F), color, 12);
        return pen.label({foot.x + pen.points(20), foot.y + pen.points(14)}, color, name);
    }
    const ImVec2 along{dx / way, dy / way};
    const float head = pen.points(9), half = pen.points(4);
    const ImVec2 neck{tip.x - along.x * head, tip.y - along.y * head};
    const ImVec2 left{neck.x - along.y * half, neck.y + along.x * half};
    const ImVec2 right{neck.x + along.y * half, neck.y - along.x * half};
    pen.line(foot, neck, color, 2.0F);
    pen.canvas.AddTriangle(tip, left, right, rim, pen.points(2));
    pen.canvas.AddTriangleFilled(tip, left, right, color);
    pen.label({tip.x + along.x * pen.points(13), tip.y + along.y * pen.points(11)}, color, name);
}

void drawArrows(const Pen& pen, const Probe& probe, std::size_t light)
{
    const double length = arrowShare * std::tan(radians(0.5 * pen.camera.fieldOfView)) * probe.distance;
    const Vec3d& P = probe.point.P;
    if (!probe.lights.empty()) {
        const ProbedLight& shown = probe.lights[std::min(light, probe.lights.size() - 1)];
        drawArrow(pen, P, shown.R, length, blue, "R");
        drawArrow(pen, P, shown.L, length, yellow, "L");
    }
    drawArrow(pen, P, probe.point.N, length, white, "N");
    drawArrow(pen, P, probe.V, length, white, "V");
}

void drawLobe(const Pen& pen, const LobeShape& lobe)
{
    for (const std::vector<Vec3d>& wire : lobe.wires)
        pen.polyline(wire, IM_COL32(0, 0, 0, 90), 2.2F);
    for (const std::vector<Vec3d>& wire : lobe.wires)
        pen.polyline(wire, (orange & 0x00FFFFFFU) | (150U << 24U), 1.0F);
    pen.polyline(lobe.inPlane, rim, 4.0F);
    pen.polyline(lobe.inPlane, orange, 2.2F);
}

/// A pin's name in a disc; pale where the object hides it.
void drawMarker(const Pen& pen, const FoundProbe& found, const std::string& name, bool looked)
{
    const ProbedPoint& point = found.a.point;
    if (point.x < 0.0)
        return;
    const bool hidden = found.a.NV <= 0.0 || (found.pixelA && !found.pixelA->seen);
    const ImVec2 centre = pen.onScreen(point.x, point.y);
    const unsigned alpha = hidden ? 90U : 255U;
    const auto faded = [alpha](ImU32 color) { return (color & 0x00FFFFFFU) | (alpha << 24U); };
    if (name.empty()) {
        pen.canvas.AddCircleFilled(centre, pen.points(4), rim, 16);
        pen.canvas.AddCircleFilled(centre, pen.points(2.5F), faded(white), 16);
        return;
    }
    const ImVec2 size = sizeIn(Face::Strong, name);
    const float radius = pen.points(9), half = std::max(radius, size.x / 2 + pen.points(5));
    const auto disc = [&](float more) { // or, for a long name, a pill
        return std::pair(ImVec2(centre.x - half - more, centre.y - radius - more),
                         ImVec2(centre.x + half + more, centre.y + radius + more));
    };
    const auto [low, high] = disc(0.0F);
    const auto [lowRim, highRim] = disc(pen.points(2));
    pen.canvas.AddRectFilled(lowRim, highRim, rim, radius + pen.points(2));
    pen.canvas.AddRectFilled(low, high, faded(looked ? palette::chosen : palette::raised), radius);
    pen.canvas.AddRect(low, high, faded(looked ? palette::accent : white), radius, 0, pen.points(1.5F));
    drawText(pen.canvas, Face::Strong, {centre.x - size.x / 2, centre.y - size.y / 2}, faded(white), name);
}

} // namespace

void drawProbeMarks(ImDrawList& canvas, const ExplorerState& state, const PictureView& view, bool isB)
{
    const ProbeStudy& study = state.probe;
    const Pen pen{canvas, view, state.scene.camera};
    if (const FoundProbe* found = study.found()) {
        const Probe& probe = isB && found->b ? *found->b : found->a;
        const std::optional<LobeShape>& lobe = isB && found->b ? study.lobeB : study.lobeA;
        if (study.lobe && lobe)
            drawLobe(pen, *lobe);
        if (study.arrows)
            drawArrows(pen, probe, study.light);
    }
    for (std::size_t i = 0; i < std::min(study.foundPins.size(), state.scene.pins.size()); ++i)
        if (study.foundPins[i])
            drawMarker(pen, *study.foundPins[i], state.scene.pins[i].name, study.picked == i);
    if (study.loose && study.foundLoose)
        drawMarker(pen, *study.foundLoose, "", true);
}

} // namespace reflectance::explorer
