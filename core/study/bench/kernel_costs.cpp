#include "core/reflectance/catalogue.h"
#include "core/reflectance/kernel_tables.h"
#include "core/study/bench/bench.h"
#include "core/study/bench/direction_rows.h"
#include "core/study/bench/interleaved.h"

namespace reflectance {
namespace {

/// The work lists of all kernels, on rows that they share.
class KernelBench {
public:
    explicit KernelBench(std::size_t rows) : exact_(rows), single_(rows) {}

    void add(const Model& model)
    {
        const std::vector<double> values = flatValues(model.text, {});
        add(model.id(), "double", model.exact, values, exact_);
        add(model.id(), "float", model.single, values, single_);
        add(model.id(), simd_, model.lanes, values, single_);
    }
    void addLobes(const Model& model)
    {
        const std::vector<double> values = flatValues(model.text, {});
        for (const LobeFormFacts& facts : lobeForms().subspan(1))
            add(model.id() + ", lobe " + std::string(facts.name), simd_, model.with(facts.form).lanes, values, single_);
    }

    [[nodiscard]] std::vector<KernelCost> run(int repetitions, Progress& progress)
    {
        constexpr double nanosecondsPerMillisecond = 1e6;
        const auto timings = interleaved(
            works_, repetitions, static_cast<double>(single_.count()) / nanosecondsPerMillisecond, progress, 1.0);
        for (std::size_t i = 0; i < timings.size(); ++i)
            costs_[i].nanoseconds = timings[i];
        return costs_;
    }

private:
    template <class T>
    void add(std::string model, std::string precision, const Kernel<T>& kernel, const std::vector<double>& values,
             DirectionRows<T>& rows)
    {
        costs_.push_back({std::move(model), std::move(precision), {}});
        // Once untimed: another kernel's directions were in the cache.
        works_.emplace_back([kernel, values, &rows] {
            kernel.shade(values.data(), rows.batch());
            return millisecondsOf([&] { kernel.shade(values.data(), rows.batch()); });
        });
    }

    DirectionRows<double> exact_;
    DirectionRows<float> single_;
    std::string simd_ = std::string("simd (") + lanesName() + ")";
    std::vector<KernelCost> costs_;
    std::vector<TimedWork> works_;
};

} // namespace

std::vector<KernelCost> kernelCosts(const BenchEffort& effort, Progress& progress)
{
    KernelBench bench(effort.rows);
    for (const Model& model : catalogue())
        if (!model.text.usesTable) // a table costs what its file makes it cost; see the growth
            bench.add(model);
    bench.addLobes(**findModel("hybrid"));
    return bench.run(effort.repetitions, progress);
}

} // namespace reflectance
