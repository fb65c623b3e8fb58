// How a picture's numbers are computed: nothing here changes what it should show.
#pragma once

#include "core/reflectance/lobe_form.h"
#include "core/reflectance/precision.h"

namespace reflectance {

/// A precision alone means the right form of everything.
struct Arithmetic {
    Precision precision = Precision::Double;
    LobeForm lobe = LobeForm::Conditioned;
    bool specialised = true; ///< terms that are 0 are left out; what is left is equal by ==

    constexpr Arithmetic() = default;
    constexpr Arithmetic(Precision p) : precision(p) {} // NOLINT(google-explicit-constructor)
    constexpr Arithmetic(Precision p, LobeForm form, bool special = true)
        : precision(p), lobe(form), specialised(special)
    {
    }

    friend bool operator==(const Arithmetic&, const Arithmetic&) = default;
};

} // namespace reflectance
