// Which numbers of a model a fit may turn, within which bounds, and on which scale.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/study/fit/observations.h"

#include <set>
#include <string>
#include <vector>

namespace reflectance {

/// One unknown. The solver sees u = value, or u = ln(value) for parameters whose slider is logarithmic.
struct Variable {
    std::string name;               ///< "n", "rho green", "K 1 2" (row 1, column 2)
    std::vector<std::size_t> slots; ///< of the model's flat list; all of them take the value
    bool isShape = false;           ///< a single number: starts are spread over these
    bool logarithmic = false;
    double low = 0.0, high = 0.0;           ///< bounds in u, from the legal range
    double usualLow = 0.0, usualHigh = 0.0; ///< the slider's ends in u

    [[nodiscard]] double fromValue(double value) const;
    [[nodiscard]] double toValue(double u) const;
    [[nodiscard]] double derivative(double u) const; ///< d value / du
};

/// Colours get one variable per channel; shapes one for all. Data without colour, and parameters named in `grey`, share one
/// number over the channels, a matrix over its diagonal; only data of the form Matrix turn all nine. `fixed` parameters are
/// left out, and so is what only steps from choice to choice.
[[nodiscard]] std::vector<Variable> variablesOf(const ModelText& model, ObservedForm form, const ParameterValues& fixed,
                                                const std::set<std::string>& grey);

/// The flat list that the variables are put into: `fixed`, the defaults elsewhere, and 0 beside the diagonal of a matrix of which
/// only the diagonal is turned.
[[nodiscard]] std::vector<double> valuesAround(const ModelText& model, ObservedForm form, const ParameterValues& fixed,
                                               const std::set<std::string>& grey);

/// The model's flat list with the variables' numbers put in.
void put(const std::vector<Variable>& variables, const double* u, std::vector<double>& flat);

/// A flat list by parameter names.
[[nodiscard]] ParameterValues namedValues(const ModelText& model, const std::vector<double>& flat);

} // namespace reflectance
