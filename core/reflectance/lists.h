// Parameters that are lists of numbers: a choice says how many of them count, each form of the list names its numbers.
#pragma once

#include "core/reflectance/catalogue.h"

namespace reflectance {

/// The form that a list takes for these values of its model; null where the choice has a value that it does not offer.
[[nodiscard]] const ListForm* formOf(const ModelText& model, const Parameter& list, const ParameterValues& values);

/// The numbers of a list in another of its forms: those of the same name are carried over, the rest is 0. Numbers whose
/// count fits no form are all left behind.
[[nodiscard]] std::vector<double> inForm(const Parameter& list, std::span<const double> numbers, const ListForm& form);

/// Whether every list holds as many numbers as its choice asks for; the error names list, counts and choice.
[[nodiscard]] Result<void> checkLists(const ModelText& model, const ParameterValues& values);

/// A flat list of values by name again; a list with as many numbers as count.
[[nodiscard]] ParameterValues valuesByName(const ModelText& model, std::span<const double> flat);

} // namespace reflectance
