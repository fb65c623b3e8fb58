#include "core/chart/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance {
namespace {

/// From a point's middle to its name, and the half side of the square that a point covers.
constexpr double gap = 6.0, dot = 4.0;
constexpr int rings = 12;
constexpr double perRing = 11.0;

double overlap(const Box& a, const Box& b)
{
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return std::max(0.0, width) * std::max(0.0, height);
}

/// The box moved into the field as far as it has room there.
Box movedInto(const Box& box, const Box& field)
{
    const auto shift = [](double low, double high, double least, double most) {
        return low < least ? least - low : high > most ? most - high : 0.0;
    };
    const double dx = shift(box.left, box.right, field.left, field.right);
    const double dy = shift(box.top, box.bottom, field.top, field.bottom);
    return {box.left + dx, box.top + dy, box.right + dx, box.bottom + dy};
}

/// The name `distance` pixels from its point, in a direction of the compass.
Box boxAt(const LabelWish& wish, double distance, int dx, int dy)
{
    const auto start = [distance](double at, double size, int side) {
        return side > 0 ? at + distance : side < 0 ? at - distance - size : at - size / 2.0;
    };
    // Slanted neighbours stand closer in y: text has room above and below.
    const auto near = [distance](double at, double size, int side) {
        return side > 0 ? at + distance / 2.0 : side < 0 ? at - distance / 2.0 - size : at - size / 2.0;
    };
    const double left = start(wish.x, wish.width, dx);
    const double top = dx != 0 ? near(wish.y, wish.height, dy) : start(wish.y, wish.height, dy);
    return {left, top, left + wish.width, top + wish.height};
}

PlacedLabel placed(const LabelWish& wish, const std::vector<Box>& taken, const Box& field)
{
    constexpr std::array<std::array<int, 2>, 8> directions{
        {{1, -1}, {1, 0}, {1, 1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}}};
    PlacedLabel best;
    double least = HUGE_VAL;
    for (int ring = 0; ring < rings; ++ring)
        for (const auto& [dx, dy] : directions) {
            const Box box = movedInto(boxAt(wish, gap + perRing * ring, dx, dy), field);
            double cost = 0.0;
            for (const Box& other : taken)
                cost += overlap(box, other);
            if (cost < least) {
                least = cost;
                best = {box, ring > 0};
            }
            if (least == 0.0)
                return best;
        }
    return best;
}

std::size_t characters(std::string_view text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; })); // UTF-8
}

} // namespace

std::vector<PlacedLabel> placedLabels(const std::vector<LabelWish>& wishes, const Box& field)
{
    std::vector<Box> taken;
    for (const LabelWish& wish : wishes)
        taken.push_back({wish.x - dot, wish.y - dot, wish.x + dot, wish.y + dot});
    std::vector<PlacedLabel> labels;
    for (const LabelWish& wish : wishes) {
        labels.push_back(wish.width > 0.0 ? placed(wish, taken, field) : PlacedLabel());
        taken.push_back(labels.back().box);
    }
    return labels;
}

LabelEnd endTowards(const Box& box, double x, double y)
{
    return {std::clamp(x, box.left, box.right), std::clamp(y, box.top, box.bottom)};
}

double textWidth(std::string_view text, int size)
{
    return 0.56 * size * static_cast<double>(characters(text));
}

std::vector<std::string_view> textLines(std::string_view text, int size, double width)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        std::size_t end = text.find(' ');
        for (std::size_t next = end; next != std::string_view::npos;) {
            next = text.find(' ', next + 1);
            if (textWidth(text.substr(0, next), size) > width)
                break;
            end = next;
        }
        if (textWidth(text, size) <= width)
            end = std::string_view::npos;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

} // namespace reflectance
