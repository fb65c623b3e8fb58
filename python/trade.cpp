// The trade: what every cheaper way to draw a scene costs and loses.
#include "core/study/trade/trade_run.h"
#include "python/arrays.h"
#include "python/scenes.h"

#include <pybind11/stl.h>

namespace reflectance::python {
namespace {

py::list trade(const std::string& scene, int width, int height, int samples, int repetitions,
               const std::vector<std::string>& rungs)
{
    const RenderSettings settings = unwrapped(checkedSettings(width, height, samples));
    if (repetitions < 1 || repetitions > 1000)
        throw py::value_error("repetitions must be within 1 .. 1000");
    TradeOptions options;
    options.repetitions = repetitions;
    options.only = rungs;
    const Scene shown = sceneFrom(scene);
    const auto measured = [&] {
        const py::gil_scoped_release others;
        return measuredTrade(shown, settings, options, nullptr);
    }();
    py::list found;
    for (const Candidate& candidate : unwrapped(measured).candidates) {
        py::dict one;
        one["name"] = nameOf(candidate.recipe);
        one["precision"] = std::string(nameOf(candidate.recipe.precision));
        one["rungs"] = candidate.recipe.rungs;
        one["max_abs"] = candidate.error.max;
        one["rmse"] = candidate.error.rmse;
        one["de2000_p95"] = candidate.error.perceived.deltaEP95;
        one["flip_mean"] = candidate.error.perceived.flipMean;
        one["bound"] = candidate.bound;
        one["milliseconds"] = candidate.shade.median;
        one["spread"] = candidate.shade.spread;
        one["on_front"] = candidate.onFront;
        found.append(one);
    }
    return found;
}

} // namespace

void addTrade(py::module_& module)
{
    using py::arg;
    module.def("trade", &trade, arg("scene") = "", arg("width") = 256, arg("height") = 256, arg("samples") = 4,
               arg("repetitions") = 7, arg("rungs") = std::vector<std::string>(),
               "Every cheaper way to draw the scene on the CPU, measured here: a list of dicts with error to double\n"
               "at 64 samples a pixel,\n"
               "milliseconds to shade again, and whether none is both cheaper and more exact (on_front).\n\n"
               "rungs: which to try; [] for all. 'reflectance trade --help' names them.");
}

} // namespace reflectance::python
