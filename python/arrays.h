// numpy arrays and the core's values, and how errors become Python's.
#pragma once

#include "core/base/result.h"
#include "core/math/vec.h"
#include "core/reflectance/catalogue.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace reflectance::python {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The value, or ValueError with our sentence.
template <class T> T unwrapped(Result<T> result)
{
    if (!result)
        throw py::value_error(result.error().sentence());
    return *std::move(result);
}
inline void unwrapped(const Result<void>& result)
{
    if (!result)
        throw py::value_error(result.error().sentence());
}

/// Rows of three numbers: an array of shape (n, 3), or (3,) for one row that stands for all. `name` is for the sentence.
class Rows {
public:
    Rows(const py::object& given, const char* name) : numbers_(doublesOf(given, name))
    {
        const bool one = numbers_.ndim() == 1 && numbers_.shape(0) == 3;
        if (!one && !(numbers_.ndim() == 2 && numbers_.shape(1) == 3))
            throw py::value_error(std::string(name) + " must have the shape (3,) or (n, 3)");
        count_ = one ? 1 : numbers_.shape(0);
        isOne_ = one;
    }

    [[nodiscard]] py::ssize_t count() const { return count_; }
    [[nodiscard]] bool isOne() const { return isOne_; }
    [[nodiscard]] Vec3d operator[](py::ssize_t row) const
    {
        const double* at = numbers_.data() + 3 * (isOne_ ? 0 : row);
        return {at[0], at[1], at[2]};
    }

    /// Anything that numpy makes numbers of.
    [[nodiscard]] static Doubles doublesOf(const py::object& given, const char* name)
    {
        try {
            return py::cast<Doubles>(given);
        } catch (const std::exception&) {
            throw py::value_error(std::string(name) + " must be numbers, as numpy.asarray(..., float) takes them");
        }
    }

private:
    Doubles numbers_;
    py::ssize_t count_ = 0;
    bool isOne_ = false;
};

/// The number of rows that all of them agree on; one row stands for any number.
[[nodiscard]] inline py::ssize_t commonCount(std::initializer_list<const Rows*> all)
{
    py::ssize_t count = 1;
    for (const Rows* rows : all)
        if (!rows->isOne()) {
            if (count != 1 && rows->count() != count)
                throw py::value_error("arrays of directions must have as many rows as each other, or be one row");
            count = rows->count();
        }
    return count;
}

/// Parameters from a dict: numbers, or sequences of numbers.
[[nodiscard]] ParameterValues valuesFrom(const ModelText& model, const py::dict& parameters);

void addModels(py::module_& module);
void addTables(py::module_& module);
void addPictures(py::module_& module);
void addTrade(py::module_& module);

} // namespace reflectance::python
