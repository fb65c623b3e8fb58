#include "core/study/fit/shading_cost.h"

#include "core/measured/angles.h"
#include "core/reflectance/shade_block.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <numbers>

namespace reflectance {
namespace {

constexpr int rounds = 25, callsPerRound = 20;

/// Directions all over the upper hemisphere, so that every branch of a scalar kernel is met.
template <class T> void fill(ShadeBlock<T>& block)
{
    block.N.fill({0.0, 0.0, 1.0});
    block.I.fill({1.0, 1.0, 1.0});
    block.lightDisc.fill(T(0));
    const double count = static_cast<double>(blockSize);
    for (std::size_t i = 0; i < blockSize; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / count;
        const double turn = static_cast<double>(i) * 2.399963; // the golden angle
        block.L.set(i, directionAt(std::acos(share), turn));
        block.V.set(i, directionAt(std::acos(1.0 - share), std::numbers::pi - 2.0 * turn));
    }
}

template <class T> double costOf(const Kernel<T>& kernel, const std::vector<double>& flat)
{
    using Clock = std::chrono::steady_clock;
    const auto block = std::make_unique<ShadeBlock<T>>();
    fill(*block);
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        block->sum.fill({});
        const auto start = Clock::now();
        for (int call = 0; call < callsPerRound; ++call)
            kernel.shade(flat.data(), block->batch(blockSize));
        const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
        best = std::min(best, spent.count() / (callsPerRound * static_cast<double>(blockSize)));
    }
    return best;
}

} // namespace

double shadingCost(const Model& model, const std::vector<double>& flat, Precision precision)
{
    if (precision == Precision::Double)
        return costOf(model.exact, flat);
    return costOf(precision == Precision::Float ? model.single : model.lanes, flat);
}

} // namespace reflectance
