// What of a picture's accuracy the GL renderer may give up.
#pragma once

#include "core/reflectance/lobe_form.h"
#include "core/render/place.h"

namespace reflectance {

/// How a picture is shaded where accuracy may be given up; by default it is not.
struct GlShading {
    Place place = Place::Sample; ///< Sample, Fragment or Pixel
    bool halfBuffer = false;     ///< the linear picture is kept in 16-bit floats: 11 bits, nothing beyond 65504
    LobeForm lobe = LobeForm::Conditioned;
    bool specialised = true; ///< see Arithmetic

    friend bool operator==(const GlShading&, const GlShading&) = default;
};

} // namespace reflectance
