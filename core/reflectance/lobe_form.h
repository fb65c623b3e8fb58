// The forms in which (R.V)^n can be computed: the conditioned one is right, the others are cheaper, or were thought to be.
// A form is its text in shaders/lobe, its line in lobeForms, and its line in lobe_kernels.h.
#pragma once

#include "core/base/result.h"

#include <span>
#include <string_view>

namespace reflectance {

enum class LobeForm { Conditioned, Power, Squarings, Truncated, Schlick, Table };

struct LobeFormFacts {
    LobeForm form;
    std::string_view name;   ///< in flags and files: "schlick"
    std::string_view text;   ///< its file under shaders
    std::string_view about;  ///< a sentence for people
    double smallestExponent; ///< below, the form means nothing
    bool wholeExponents;     ///< made for whole n alone

    /// Largest difference to (R.V)^n in units of the peak, for exact directions and exact arithmetic; 0 where the form is
    /// equal to it. What rounding adds is that of the dot product, times n, but for conditioned and table.
    double (*bound)(double n);
};

/// All forms, in the order of the enumeration.
[[nodiscard]] std::span<const LobeFormFacts> lobeForms();
[[nodiscard]] const LobeFormFacts& factsOf(LobeForm form);

/// The form with this name, or a sentence that lists the names.
[[nodiscard]] Result<LobeForm> lobeFormNamed(std::string_view name);

/// Refuses an exponent that the form is not made for.
[[nodiscard]] Result<void> checkExponent(LobeForm form, double n);

} // namespace reflectance
