// Models on arrays of directions.
#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "python/arrays.h"

#include <pybind11/stl.h>

namespace reflectance::python {
namespace {

py::dict described(const Parameter& parameter)
{
    constexpr const char* kinds[] = {"number", "color", "matrix", "choice", "list"};
    py::dict found;
    found["name"] = parameter.name;
    found["label"] = parameter.label;
    found["kind"] = kinds[static_cast<int>(parameter.kind)];
    found["unit"] = parameter.unit;
    found["default"] = parameter.initial;
    found["legal"] = py::make_tuple(parameter.legalMin, parameter.legalMax);
    found["about"] = parameter.tooltip;
    found["source"] = parameter.source;
    return found;
}

py::list models()
{
    py::list all;
    for (const Model& model : catalogue()) {
        py::list parameters;
        for (const Parameter& parameter : model.text.parameters)
            parameters.append(described(parameter));
        py::dict found;
        found["id"] = model.id();
        found["name"] = model.text.name;
        found["formula"] = model.text.formula;
        found["citation"] = model.text.citation;
        found["reciprocal"] = model.text.reciprocal.holds;
        found["passive"] = model.text.passive.holds;
        found["parameters"] = parameters;
        all.append(found);
    }
    return all;
}

Precision precisionNamed(const std::string& name)
{
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd})
        if (nameOf(precision) == name)
            return precision;
    throw py::value_error("precision '" + name + "' is unknown here; choose double, float or simd");
}

Doubles evaluateRows(const std::string& id, const py::object& N, const py::object& L, const py::object& V,
                     const py::dict& parameters, const py::object& I, double radius, const std::string& precision)
{
    const Model& model = *unwrapped(findModel(id));
    if (model.text.usesTable)
        throw py::value_error("the model table needs a measurement; ask Table.brdf(L, V) instead");
    const Rows normals(N, "N"), lights(L, "L"), views(V, "V"), intensities(I, "I");
    const auto count = commonCount({&normals, &lights, &views, &intensities});
    std::vector<Observation> rows(static_cast<std::size_t>(count));
    for (py::ssize_t i = 0; i < count; ++i)
        rows[static_cast<std::size_t>(i)] = {normals[i], views[i], {{lights[i], intensities[i], radius}}};
    const std::vector<double> values = flatValues(model.text, valuesFrom(model.text, parameters));
    const Precision arithmetic = precisionNamed(precision);
    std::vector<Vec3d> factors;
    {
        const py::gil_scoped_release others;
        factors = evaluate(model, values, rows, arithmetic);
    }
    Doubles result({count, py::ssize_t{3}});
    double* out = result.mutable_data();
    for (const Vec3d& factor : factors)
        for (const double channel : {factor.x, factor.y, factor.z})
            *out++ = channel;
    return result;
}

} // namespace

ParameterValues valuesFrom(const ModelText& model, const py::dict& parameters)
{
    ParameterValues values;
    for (const auto& [key, value] : parameters) {
        const auto name = py::cast<std::string>(py::str(key));
        const Doubles numbers = Rows::doublesOf(py::reinterpret_borrow<py::object>(value), name.c_str());
        std::string assignment = name + "=";
        for (py::ssize_t i = 0; i < numbers.size(); ++i)
            assignment += (i > 0 ? " " : "") + shortest(numbers.data()[i]);
        unwrapped(setParameter(model, assignment, values));
    }
    return values;
}

void addModels(py::module_& module)
{
    using py::arg;
    module.def("models", &models,
               "The catalogue: a list of dicts with id, name, formula, citation, what holds, parameters.");
    module.def("evaluate", &evaluateRows, arg("model"), arg("N"), arg("L"), arg("V"), arg("parameters") = py::dict(),
               arg("I") = py::make_tuple(1.0, 1.0, 1.0), arg("radius") = 0.0, arg("precision") = "double",
               "The factor times the light, cosine included, for each row: an array of shape (n, 3).\n\n"
               "N, L, V, I: shape (n, 3), or (3,) for all rows. parameters: {'ks': 0.5, 'K': [0.2, 0.3, 0.4]}.\n"
               "radius: the light's angular radius in degrees, which serves the mirror.\n"
               "precision: 'double' (the truth), 'float' or 'simd'.");
}

} // namespace reflectance::python
