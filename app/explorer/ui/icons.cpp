#include "app/explorer/ui/icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace reflectance::explorer {

namespace {

/// Coordinates of the icons are -1 .. 1, y down.
struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float radius;
    ImU32 color;
    float width;

    ImVec2 at(float x, float y) const { return {centre.x + x * radius, centre.y + y * radius}; }
    ImVec2 onCircle(float degrees, float r) const
    {
        const float a = degrees * std::numbers::pi_v<float> / 180.0F;
        return at(r * std::cos(a), r * std::sin(a));
    }
    template <std::size_t count> void line(const std::array<ImVec2, count>& points, bool closed = false) const
    {
        std::array<ImVec2, count> placed;
        std::transform(points.begin(), points.end(), placed.begin(), [this](ImVec2 p) { return at(p.x, p.y); });
        list.AddPolyline(placed.data(), static_cast<int>(count), color, closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                         width);
    }
    void circle(float x, float y, float r) const { list.AddCircle(at(x, y), r * radius, color, 0, width); }
    void arc(float fromDegrees, float toDegrees, float r) const
    {
        constexpr float toRadians = std::numbers::pi_v<float> / 180.0F;
        list.PathArcTo(centre, r * radius, fromDegrees * toRadians, toDegrees * toRadians);
        list.PathStroke(color, ImDrawFlags_None, width);
    }
};

void drawFolder(const Pen& pen)
{
    pen.line(
        std::array<ImVec2, 7>{
            {{-1, 0.75F}, {-1, -0.65F}, {-0.3F, -0.65F}, {-0.05F, -0.35F}, {1, -0.35F}, {1, 0.75F}, {-1, 0.75F}}},
        true);
}

/// An arrow that turns back, to the left for `side` -1.
void drawTurn(const Pen& pen, float side)
{
    pen.line(std::array<ImVec2, 2>{{{side * 0.85F, -0.35F}, {-side * 0.2F, -0.35F}}});
    std::array<ImVec2, 13> bow;
    for (std::size_t i = 0; i < bow.size(); ++i) {
        const float a = (-90.0F + 15.0F * static_cast<float>(i)) * std::numbers::pi_v<float> / 180.0F;
        bow[i] = {-side * (0.2F + 0.55F * std::cos(a)), 0.2F + 0.55F * std::sin(a)};
    }
    pen.line(bow);
    pen.line(std::array<ImVec2, 2>{{{-side * 0.2F, 0.75F}, {side * 0.35F, 0.75F}}});
    pen.line(std::array<ImVec2, 3>{{{side * 0.35F, -0.85F}, {side * 0.9F, -0.35F}, {side * 0.35F, 0.15F}}});
}

void drawFrame(const Pen& pen)
{
    for (const float x : {-1.0F, 1.0F})
        for (const float y : {-1.0F, 1.0F})
            pen.line(std::array<ImVec2, 3>{{{0.85F * x, 0.35F * y}, {0.85F * x, 0.85F * y}, {0.35F * x, 0.85F * y}}});
    pen.circle(0, 0, 0.3F);
}

void drawTurntable(const Pen& pen)
{
    pen.arc(-50, 230, 0.8F);
    const ImVec2 tip = pen.onCircle(-50, 0.8F);
    const float r = 0.42F * pen.radius;
    pen.list.AddTriangleFilled({tip.x - r, tip.y - 0.7F * r}, {tip.x + 0.7F * r, tip.y - 0.9F * r},
                               {tip.x + 0.3F * r, tip.y + 0.9F * r}, pen.color);
}

void drawSun(const Pen& pen)
{
    pen.circle(0, 0, 0.42F);
    for (int ray = 0; ray < 8; ++ray) {
        const auto degrees = static_cast<float>(45 * ray);
        pen.list.AddLine(pen.onCircle(degrees, 0.68F), pen.onCircle(degrees, 1.0F), pen.color, pen.width);
    }
}

void drawHalves(const Pen& pen)
{
    pen.circle(0, 0, 0.9F);
    pen.list.PathArcTo(pen.centre, 0.9F * pen.radius, 0.5F * std::numbers::pi_v<float>,
                       1.5F * std::numbers::pi_v<float>);
    pen.list.PathFillConvex(pen.color);
}

void drawCamera(const Pen& pen)
{
    pen.line(std::array<ImVec2, 8>{{{-1, 0.75F},
                                    {-1, -0.45F},
                                    {-0.45F, -0.45F},
                                    {-0.25F, -0.8F},
                                    {0.25F, -0.8F},
                                    {0.45F, -0.45F},
                                    {1, -0.45F},
                                    {1, 0.75F}}},
             true);
    pen.circle(0, 0.12F, 0.36F);
}

void drawLens(const Pen& pen)
{
    pen.circle(-0.2F, -0.2F, 0.66F);
    pen.line(std::array<ImVec2, 2>{{{0.3F, 0.3F}, {0.95F, 0.95F}}});
}

/// A spot of light in a ring, and where it goes.
void drawSpot(const Pen& pen)
{
    pen.list.AddCircleFilled(pen.at(-0.3F, 0.3F), 0.3F * pen.radius, pen.color);
    pen.circle(-0.3F, 0.3F, 0.62F);
    pen.line(std::array<ImVec2, 2>{{{0.2F, -0.2F}, {0.9F, -0.9F}}});
    pen.line(std::array<ImVec2, 3>{{{0.3F, -0.9F}, {0.9F, -0.9F}, {0.9F, -0.3F}}});
}

void drawReset(const Pen& pen)
{
    pen.arc(-230, 50, 0.8F);
    const ImVec2 tip = pen.onCircle(-230, 0.8F);
    const float r = 0.42F * pen.radius;
    pen.list.AddTriangleFilled({tip.x + r, tip.y + 0.7F * r}, {tip.x - 0.7F * r, tip.y + 0.9F * r},
                               {tip.x - 0.3F * r, tip.y - 0.9F * r}, pen.color);
}

/// A flag.
void drawFlag(const Pen& pen)
{
    pen.line(std::array<ImVec2, 2>{{{-0.55F, 1.0F}, {-0.55F, -0.95F}}});
    pen.line(std::array<ImVec2, 4>{{{-0.55F, -0.85F}, {0.8F, -0.4F}, {-0.55F, 0.1F}, {-0.55F, -0.85F}}}, true);
}

void drawQuestion(const Pen& pen)
{
    pen.circle(0, 0, 0.95F);
    pen.list.PathArcTo(pen.at(0, -0.22F), 0.33F * pen.radius, -std::numbers::pi_v<float>,
                       0.45F * std::numbers::pi_v<float>);
    pen.list.PathLineTo(pen.at(0, 0.3F));
    pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width);
    pen.list.AddCircleFilled(pen.at(0, 0.58F), 0.11F * pen.radius, pen.color);
}

} // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float radius, ImU32 color)
{
    const Pen pen{list, centre, radius, color, std::max(1.2F, radius / 5.5F)};
    switch (icon) {
    case Icon::Open:
        return drawFolder(pen);
    case Icon::Undo:
        return drawTurn(pen, -1.0F);
    case Icon::Redo:
        return drawTurn(pen, 1.0F);
    case Icon::Frame:
        return drawFrame(pen);
    case Icon::Turntable:
        return drawTurntable(pen);
    case Icon::Lights:
        return drawSun(pen);
    case Icon::Compare:
        return drawHalves(pen);
    case Icon::Camera:
        return drawCamera(pen);
    case Icon::Lens:
        return drawLens(pen);
    case Icon::Grab:
        return drawSpot(pen);
    case Icon::Reset:
        return drawReset(pen);
    case Icon::Tour:
        return drawFlag(pen);
    case Icon::Help:
        return drawQuestion(pen);
    }
}

} // namespace reflectance::explorer
