// Measured tables: read, made of a model, looked up, written.
#include "core/base/file.h"
#include "core/measured/load.h"
#include "core/measured/resample.h"
#include "core/measured/write.h"
#include "core/study/tables/sample_model.h"
#include "python/arrays.h"

#include <limits>
#include <pybind11/stl.h>

namespace reflectance::python {
namespace {

/// Anything measured; a class of its own so that Python sees one type.
struct Measured {
    Measurement data;

    [[nodiscard]] Doubles brdf(const py::object& L, const py::object& V) const
    {
        const Rows lights(L, "L"), views(V, "V");
        const auto count = commonCount({&lights, &views});
        Doubles result({count, py::ssize_t{3}, py::ssize_t{3}});
        double* out = result.mutable_data();
        const Vec3d nothing(std::numeric_limits<double>::quiet_NaN());
        const Mat3d hole{{nothing, nothing, nothing}};
        for (py::ssize_t i = 0; i < count; ++i) {
            const auto K = brdfAt(data, normalized(lights[i]), normalized(views[i]));
            for (const Vec3d& at : K.value_or(hole).rows)
                for (const double number : {at.x, at.y, at.z})
                    *out++ = number;
        }
        return result;
    }

    [[nodiscard]] py::dict info() const
    {
        const Provenance& from = provenanceOf(data);
        py::dict found;
        found["name"] = from.name;
        found["format"] = from.format;
        found["convention"] = from.convention;
        found["surfaces"] = from.surfaces;
        found["samples"] = from.samples;
        found["holes"] = from.holes;
        found["negatives"] = from.negatives;
        found["channels"] = channelsOf(data);
        found["warnings"] = from.warnings;
        return found;
    }

    void save(const std::string& path) const
    {
        const TableFormat format = unwrapped(tableFormatOf(path));
        const Table table = gridOf(data);
        unwrapped(checkHolds(format, table));
        unwrapped(writeAtomically(path, bytesOf(format, table)));
    }
};

Measured load(const std::string& path, std::size_t surface, std::optional<double> wavelength)
{
    return {unwrapped(loadMeasurement(path, {surface, wavelength}))};
}

Measured sampleModel(const std::string& id, const py::dict& parameters, std::size_t thetas, std::size_t phis)
{
    const Model& model = *unwrapped(findModel(id));
    if (model.text.usesTable || model.text.usesLightSize)
        throw py::value_error("model " + id + " has no BRDF of its own to sample");
    if (thetas < 2 || phis < 2 || thetas > 1000 || phis > 1000)
        throw py::value_error("thetas and phis must be within 2 .. 1000");
    return {sampledModel(model, flatValues(model.text, valuesFrom(model.text, parameters)),
                         isotropicShape(thetas, phis), Interpolation::Linear, 9)
                .table};
}

} // namespace

void addTables(py::module_& module)
{
    using py::arg;
    py::class_<Measured>(module, "Table", "A measured surface, or a model sampled into a table.")
        .def(
            py::init(&load), arg("path"), arg("surface") = 1, arg("wavelength") = py::none(),
            "Reads any measurement that the program reads (CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT, Zemax).\n\n"
            "surface: which one of a file that holds several, from 1. wavelength: nm, of a spectral file.")
        .def("brdf", &Measured::brdf, arg("L"), arg("V"),
             "f(L, V) in 1/sr as matrices of shape (n, 3, 3); directions about N = (0, 0, 1). NaN where it was not "
             "measured.")
        .def("save", &Measured::save, arg("path"),
             "Writes it: .csv, .binary (MERL), .json or .xompt (OpenMATERIAL 3D).")
        .def_property_readonly("info", &Measured::info,
                               "Format, convention, counts of samples, holes and negative numbers.");
    module.def("sample", &sampleModel, arg("model"), arg("parameters") = py::dict(), arg("thetas") = 31,
               arg("phis") = 37, "A model on an isotropic grid: thetas steps of 0 .. 90 degrees, phis of 0 .. 180.");
}

} // namespace reflectance::python
