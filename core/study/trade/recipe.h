// A recipe: everything that decides how a picture is made, from the scene's terms to the arithmetic. Rungs change it.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/render/place.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace reflectance {

struct Recipe {
    Scene scene;
    RenderSettings settings;                 ///< size of the picture that is shown, and its samples
    Precision precision = Precision::Double; ///< Glsl: the GL renderer, else the CPU renderer
    LobeForm lobe = LobeForm::Conditioned;
    Place place = Place::Sample;
    bool lobePerSample = false; ///< with Place::Vertex: the hybrid's body per vertex, its highlight at every sample
    int reduction = 1;          ///< drawn at 1 / reduction of width and height, then upscaled (core/image/upscale.h)
    bool specialised = true;    ///< what the scene does not require is left out
    bool halfBuffer = false;    ///< GL keeps the linear picture in 16-bit floats
    std::vector<std::string> rungs = {}; ///< taken so far, by id

    [[nodiscard]] Arithmetic arithmetic() const { return {precision, lobe, specialised}; } ///< on the CPU
    [[nodiscard]] bool onGl() const { return precision == Precision::Glsl; }
};

/// What is drawn before it is upscaled.
[[nodiscard]] RenderSettings drawnSettings(const Recipe& recipe);

/// "simd + 1 sample + no highlight": its rungs, or "as it is".
[[nodiscard]] std::string nameOf(const Recipe& recipe);

} // namespace reflectance
