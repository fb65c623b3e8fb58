// Pictures as arrays: rendered, compared.
#include "core/image/compare.h"
#include "core/image/perceived.h"
#include "core/render/pictures/render_picture.h"
#include "python/arrays.h"
#include "python/scenes.h"

#include <algorithm>
#include <pybind11/stl.h>

namespace reflectance::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

RenderPlan planFor(const std::string& renderer)
{
    RenderPlan plan;
    plan.backend = renderer == "glsl" ? Backend::Gl : Backend::Cpu;
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd, Precision::Glsl})
        if (nameOf(precision) == renderer) {
            plan.precision = precision == Precision::Glsl ? Precision::Double : precision;
            return plan;
        }
    throw py::value_error("renderer '" + renderer + "' is unknown; choose double, float, simd or glsl");
}

Floats render(const std::string& scene, int width, int height, int samples, const std::string& renderer)
{
    const RenderSettings settings = unwrapped(checkedSettings(width, height, samples));
    const RenderPlan plan = planFor(renderer);
    const Scene shown = sceneFrom(scene);
    Image image;
    {
        const py::gil_scoped_release others;
        auto rendered = renderPicture(shown, settings, plan);
        if (rendered)
            image = std::move(rendered->image);
        else {
            const py::gil_scoped_acquire back;
            throw py::value_error(rendered.error().sentence());
        }
    }
    Floats result({py::ssize_t{height}, py::ssize_t{width}, py::ssize_t{3}});
    std::copy(image.rgb.begin(), image.rgb.end(), result.mutable_data());
    return result;
}

Image imageFrom(const py::object& given, const char* name)
{
    Floats numbers;
    try {
        numbers = py::cast<Floats>(given);
    } catch (const std::exception&) {
        throw py::value_error(std::string(name) + " must be numbers");
    }
    if (numbers.ndim() != 3 || numbers.shape(2) != 3 || numbers.size() == 0 || numbers.shape(0) > 16384 ||
        numbers.shape(1) > 16384)
        throw py::value_error(std::string(name) + " must have the shape (height, width, 3), sides within 1 .. 16384");
    Image image(static_cast<int>(numbers.shape(1)), static_cast<int>(numbers.shape(0)));
    std::copy(numbers.data(), numbers.data() + numbers.size(), image.rgb.begin());
    return image;
}

py::dict compare(const py::object& a, const py::object& b)
{
    const Image first = imageFrom(a, "a"), second = imageFrom(b, "b");
    const Comparison difference = unwrapped(compared(first, second));
    const PerceivedDifference seen = PerceivedReference(first).to(second);
    py::dict found;
    found["identical"] = difference.identical;
    found["max_abs"] = difference.maxAbs;
    found["rmse"] = difference.rmse;
    found["mean_abs"] = difference.meanAbs;
    found["max_relative"] = difference.maxRelative;
    found["de2000_mean"] = seen.deltaEMean;
    found["de2000_p95"] = seen.deltaEP95;
    found["de2000_max"] = seen.deltaEMax;
    found["flip_mean"] = seen.flipMean;
    return found;
}

} // namespace

void addPictures(py::module_& module)
{
    using py::arg;
    module.def("render", &render, arg("scene") = "", arg("width") = 256, arg("height") = 256, arg("samples") = 4,
               arg("renderer") = "double",
               "A picture of shape (height, width, 3), linear and unclamped, rows from the top.\n\n"
               "scene: a scene file, or its JSON text; '' is the clay mug. samples per pixel: 1, 4, 9 .. 64.\n"
               "renderer: 'double' (the truth), 'float', 'simd' or 'glsl'.");
    module.def("compare", &compare, arg("a"), arg("b"),
               "Figures of the difference of two linear pictures: max_abs, rmse, de2000_mean, flip_mean and others.");
}

} // namespace reflectance::python
