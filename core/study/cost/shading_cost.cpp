#include "core/study/cost/shading_cost.h"

#include "core/measured/angles.h"
#include "core/reflectance/shade_block.h"
#include "core/study/cost/instructions.h"
#include "core/study/cost/timing.h"

#include <algorithm>
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
    const auto block = std::make_unique<ShadeBlock<T>>();
    fill(*block);
    const ShadeBatch<T> batch = block->batch(blockSize);
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        block->sum.fill({});
        const double spent = millisecondsOf([&] {
            for (int call = 0; call < callsPerRound; ++call)
                kernel.shade(flat.data(), batch);
        });
        best = std::min(best, 1e6 * spent / (callsPerRound * static_cast<double>(blockSize)));
    }
    return best;
}

template <class T>
std::optional<double> instructionsPerShading(const Kernel<T>& kernel, const std::vector<double>& flat)
{
    const auto block = std::make_unique<ShadeBlock<T>>();
    fill(*block);
    block->sum.fill({});
    const auto count = instructionsOf([&] { kernel.shade(flat.data(), block->batch(blockSize)); });
    if (!count)
        return std::nullopt;
    return static_cast<double>(*count) / static_cast<double>(blockSize);
}

/// As shadeSamples chooses.
const Kernels& kernelsOf(const RequiredModel& required, const Arithmetic& arithmetic)
{
    return arithmetic.lobe != LobeForm::Conditioned && required.model->text.usesLobe
               ? required.model->with(arithmetic.lobe)
               : required.model->with(required.form);
}

double costOf(const Kernels& kernels, Precision precision, const std::vector<double>& flat)
{
    if (precision == Precision::Double)
        return costOf(kernels.exact, flat);
    return costOf(precision == Precision::Float ? kernels.single : kernels.lanes, flat);
}

} // namespace

double shadingCost(const Model& model, const std::vector<double>& flat, const Arithmetic& arithmetic)
{
    return costOf(model.with(arithmetic.lobe), arithmetic.precision, flat);
}

double shadingCost(const RequiredModel& required, const Arithmetic& arithmetic)
{
    return costOf(kernelsOf(required, arithmetic), arithmetic.precision, required.values);
}

std::optional<double> shadingInstructions(const RequiredModel& required, const Arithmetic& arithmetic)
{
    const Kernels& kernels = kernelsOf(required, arithmetic);
    if (arithmetic.precision == Precision::Double)
        return instructionsPerShading(kernels.exact, required.values);
    return instructionsPerShading(arithmetic.precision == Precision::Float ? kernels.single : kernels.lanes,
                                  required.values);
}

} // namespace reflectance
