#include "core/measured/table.h"

#include "core/base/text.h"
#include "core/measured/interpolate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rim = 1e-9;
constexpr double leastStep = 1e-12; ///< radians: slopes stay finite

/// Into the range of the axis: mirror-symmetric tables list azimuths up to pi, others up to 2 pi.
double foldedAzimuth(double phi, double last)
{
    if (last <= pi + rim)
        return std::fabs(phi);
    return phi < 0.0 ? phi + 2.0 * pi : phi;
}

std::string complaint(const Table& table, std::size_t axis)
{
    const auto& at = table.axes[axis];
    const std::string name(angleNames(table.system)[axis]);
    const double largest = largestAngle(table.system, axis);
    if (at.empty())
        return "the angle " + name + " has no value";
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!(at[i] >= -rim && at[i] <= largest + rim))
            return "the angle " + name + " = " + general(at[i] * 180.0 / pi, 6) + " degrees lies outside 0 .. " +
                   general(largest * 180.0 / pi, 6);
        if (i > 0 && !(at[i] - at[i - 1] > leastStep))
            return "the angles " + name + " do not ascend at " + general(at[i] * 180.0 / pi, 6) + " degrees";
    }
    return {};
}

} // namespace

Result<void> checkedTable(const Table& table)
{
    const std::string& file = table.provenance.name;
    if (table.channels != 1 && table.channels != 3 && table.channels != 9)
        return Error{"has " + std::to_string(table.channels) + " numbers per sample; 1, 3 or 9 are possible", file};
    if (table.axes.size() != angleNames(table.system).size())
        return Error{"has " + std::to_string(table.axes.size()) + " angles; its system has another number", file};
    std::size_t samples = 1;
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        if (std::string text = complaint(table, axis); !text.empty())
            return Error{std::move(text), file};
        samples *= table.axes[axis].size();
    }
    if (table.values.size() != samples * table.channels)
        return Error{"has " + std::to_string(table.values.size()) + " numbers where its angles ask for " +
                         std::to_string(samples * table.channels),
                     file};
    return {};
}

std::optional<Channels> valueAt(const Table& table, const Angles& at)
{
    Places places;
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        const auto& samples = table.axes[axis];
        const bool isAzimuth = axis == 2 && table.system != AngleSystem::HalfDifference;
        const double angle = isAzimuth ? foldedAzimuth(at[axis], samples.back()) : at[axis];
        if (!(angle >= samples.front() - rim && angle <= samples.back() + rim))
            return std::nullopt;
        places[axis] = placeIn(samples, angle);
    }
    const Share share = interpolated(table, places);
    return share.weight < 0.5 ? std::nullopt : std::optional(share.values);
}

std::optional<Mat3d> brdfAt(const Table& table, const Vec3d& L, const Vec3d& V)
{
    if (!(L.z > 0.0) || !(V.z > 0.0))
        return std::nullopt;
    const auto values = valueAt(table, anglesOf(table.system, L, V));
    return values ? std::optional(matrixOf(*values, table.channels)) : std::nullopt;
}

Mat3d matrixOf(const Channels& v, std::size_t channels)
{
    if (channels == 9)
        return {{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}};
    const bool isGrey = channels == 1;
    return {{{v[0], 0.0, 0.0}, {0.0, isGrey ? v[0] : v[1], 0.0}, {0.0, 0.0, isGrey ? v[0] : v[2]}}};
}

} // namespace reflectance
