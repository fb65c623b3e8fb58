#include "core/study/properties/albedo.h"

#include "core/math/angle.h"
#include "core/reflectance/shade_block.h"

#include <algorithm>
#include <numbers>

namespace reflectance::properties {
namespace {

constexpr Vec3d up{0, 0, 1};
constexpr int leaningOrders[] = {12, 18, 36, 72};
constexpr int uprightOrders[] = {6, 9, 12, 18};
constexpr double wanted = 1e-7; ///< of two orders' difference, so that a share is right to 1e-6

/// Sums weight(direction) * value over the grid; put(block, i, direction) sets L and V of a row.
template <class Put, class Weight>
Vec3d weightedSum(const Model& model, std::span<const double> values, double lightDisc,
                  const MeasuredSurface<double>& measured, const std::vector<WeightedDirection>& grid, const Put& put,
                  const Weight& weight)
{
    ShadeBlock<double> block;
    block.N.fill(up);
    block.I.fill(Vec3d(1.0));
    block.lightDisc.fill(lightDisc);
    Vec3d total;
    for (std::size_t begin = 0; begin < grid.size(); begin += blockSize) {
        const std::size_t count = std::min(blockSize, grid.size() - begin);
        block.sum.fill({});
        for (std::size_t i = 0; i < count; ++i)
            put(block, i, grid[begin + i].direction);
        ShadeBatch<double> batch = block.batch(count);
        batch.measured = measured;
        model.exact.shade(values.data(), batch);
        for (std::size_t i = 0; i < count; ++i)
            total += weight(grid[begin + i]) * block.sum[i];
    }
    return total;
}

Vec3d one(const void*, const Vec3d&)
{
    return Vec3d(1.0);
}

double largestDistance(const Vec3d& a, const Vec3d& b)
{
    const Vec3d d = a - b;
    return std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
}

bool isGood(const Share& share)
{
    return share.error <= wanted * std::max(1.0, largestDistance(share.value, {}));
}

} // namespace

HemisphereSums::HemisphereSums(double angle)
    : angle_(angle), discRadius_(std::min(5.0, 0.5 * (90.0 - angle))),
      fixed_(-std::sin(radians(angle)), 0.0, std::cos(radians(angle)))
{
}

Share HemisphereSums::refined(Sum sum, const Model& model, std::span<const double> values)
{
    const Share first = refinedOn(uprightFirst_, sum, model, values);
    if (isGood(first))
        return first;
    const Share other = refinedOn(!uprightFirst_, sum, model, values);
    if (isGood(other))
        uprightFirst_ = !uprightFirst_;
    return other.error < first.error ? other : first;
}

Share HemisphereSums::refinedOn(bool upright, Sum sum, const Model& model, std::span<const double> values)
{
    Grids& grids = upright ? upright_ : leaning_;
    Share share;
    for (std::size_t i = 0; i < std::size(leaningOrders); ++i) {
        if (i == grids.size())
            grids.push_back(upright ? uprightHemisphere(radians(angle_), uprightOrders[i])
                                    : hemisphere({radians(angle_), radians(discRadius_)}, leaningOrders[i]));
        const Vec3d finer = (this->*sum)(model, values, grids[i]);
        share.error = largestDistance(finer, share.value);
        share.value = finer;
        if (i > 0 && isGood(share))
            break;
    }
    return share;
}

Share HemisphereSums::albedo(const Model& model, std::span<const double> values)
{
    return refined(&HemisphereSums::albedoSum, model, values);
}

Share HemisphereSums::furnace(const Model& model, std::span<const double> values)
{
    return refined(&HemisphereSums::furnaceSum, model, values);
}

Vec3d HemisphereSums::albedoSum(const Model& model, std::span<const double> values,
                                const std::vector<WeightedDirection>& grid) const
{
    const auto put = [this](ShadeBlock<double>& block, std::size_t i, const Vec3d& V) {
        block.L.set(i, fixed_);
        block.V.set(i, V);
    };
    const auto weight = [](const WeightedDirection& V) { return V.weight * V.direction.z; };
    const double radius = std::sin(radians(discRadius_));
    const double arriving = std::numbers::pi * fixed_.z * (model.text.usesLightSize ? radius * radius : 1.0);
    return weightedSum(model, values, squaredChord(discRadius_), measured_, grid, put, weight) / arriving;
}

Vec3d HemisphereSums::furnaceSum(const Model& model, std::span<const double> values,
                                 const std::vector<WeightedDirection>& grid) const
{
    const auto put = [this](ShadeBlock<double>& block, std::size_t i, const Vec3d& L) {
        block.L.set(i, L);
        block.V.set(i, fixed_);
    };
    const auto weight = [](const WeightedDirection& L) { return L.weight; };
    Vec3d seen = weightedSum(model, values, 0.0, measured_, grid, put, weight) / std::numbers::pi;
    if (model.exact.environment) {
        ShadeBlock<double> block;
        block.N.set(0, up);
        block.V.set(0, fixed_);
        block.sum.fill({});
        model.exact.environment(values.data(), block.environmentBatch(1, {one, nullptr}));
        seen += block.sum[0];
    }
    return seen;
}

} // namespace reflectance::properties
