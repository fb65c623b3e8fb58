#include "core/study/trade/rungs/rungs.h"

#include "core/measured/table.h"

#include <algorithm>

namespace reflectance {

std::span<const Rung> rungs()
{
    using namespace rung;
    constexpr auto code = [](auto choice) { return static_cast<int>(choice); };
    static constexpr Rung all[] = {
        {"double", RungAxis::Precision, "nothing: the truth's own arithmetic", true, false, inPrecision,
         code(Precision::Double)},
        {"float", RungAxis::Precision, "9 of 16 digits", true, false, inPrecision, code(Precision::Float)},
        {"simd", RungAxis::Precision, "9 of 16 digits, in lanes", true, false, inPrecision, code(Precision::Simd)},
        {"glsl", RungAxis::Precision, "9 of 16 digits, in the shader", false, true, inPrecision, code(Precision::Glsl)},
        {"half_buffer", RungAxis::Precision, "13 of 24 bits of the picture that is kept", false, true, halfBuffer},

        {"k_diagonal", RungAxis::Matrix, "the off-diagonal entries of K", true, true, diagonalK},
        {"k_white", RungAxis::Matrix, "K but for the colour under white light", true, true, colourUnderWhite},
        {"k_grey", RungAxis::Matrix, "the colour of the body", true, true, greyK},

        {"lobe_power", RungAxis::Lobe, "the lobe's conditioned form, for pow of the dot product", true, true, lobeAs,
         code(LobeForm::Power)},
        {"lobe_squarings", RungAxis::Lobe, "the lobe's conditioned form, for repeated squaring", true, true, lobeAs,
         code(LobeForm::Squarings)},
        {"lobe_truncated", RungAxis::Lobe, "the lobe, for (1 - n (1 - c) / k)^k", true, true, lobeAs,
         code(LobeForm::Truncated)},
        {"lobe_schlick", RungAxis::Lobe, "the lobe, for c / (n - n c + c)", true, true, lobeAs,
         code(LobeForm::Schlick)},
        {"lobe_table", RungAxis::Lobe, "the lobe, for 256 steps in sqrt(1 - c)", true, true, lobeAs,
         code(LobeForm::Table)},

        {"general_path", RungAxis::Requirements, "nothing, and nothing is left out that the scene does not require",
         true, true, generalPath},

        {"no_highlight", RungAxis::Model, "the highlight", true, true, withoutHighlight},
        {"oren_nayar", RungAxis::Model, "interreflection in the grooves (the A/B form)", true, true,
         qualitativeOrenNayar},
        {"eon", RungAxis::Model, "Oren-Nayar's own form, for one that keeps energy", true, true, energyPreserving, 0},
        {"eon_polynomial", RungAxis::Model, "Oren-Nayar's own form, for EON with a polynomial", true, true,
         energyPreserving, 1},
        {"lambert", RungAxis::Model, "roughness", true, true, smoothMatte},

        {"multisampled", RungAxis::Place, "all shadings of a triangle in a pixel but one", true, true, shadedAt,
         code(Place::Fragment)},
        {"once_per_pixel", RungAxis::Place, "all shadings of a pixel but one", true, true, shadedAt,
         code(Place::Pixel)},
        {"body_per_vertex", RungAxis::Place, "the body's shading but at vertices", true, false, bodyPerVertex},
        {"per_vertex", RungAxis::Place, "shading but at vertices", true, false, shadedAt, code(Place::Vertex)},
        {"per_face", RungAxis::Place, "shading but once per triangle", true, false, shadedAt, code(Place::Face)},

        {"1_sample", RungAxis::Samples, "smooth edges and small highlights", true, true, samplesPerAxis, 1},
        {"4_samples", RungAxis::Samples, "samples per pixel beyond 4", true, true, samplesPerAxis, 2},
        {"9_samples", RungAxis::Samples, "samples per pixel beyond 9", true, true, samplesPerAxis, 3},
        {"16_samples", RungAxis::Samples, "samples per pixel beyond 16", true, true, samplesPerAxis, 4},
        {"25_samples", RungAxis::Samples, "samples per pixel beyond 25", true, true, samplesPerAxis, 5},
        {"36_samples", RungAxis::Samples, "samples per pixel beyond 36", true, true, samplesPerAxis, 6},
        {"49_samples", RungAxis::Samples, "samples per pixel beyond 49", true, true, samplesPerAxis, 7},
        {"64_samples", RungAxis::Samples, "samples per pixel beyond 64", true, true, samplesPerAxis, 8},

        {"half_size", RungAxis::Resolution, "three of four pixels", true, true, reducedBy, 2},
        {"quarter_size", RungAxis::Resolution, "15 of 16 pixels", true, true, reducedBy, 4},

        {"as_table", RungAxis::Table, "the formula, for a table of it", true, true, asTable},
        {"table_every_2nd", RungAxis::Table, "every other angle of the table", true, true, thinnedTable, 2},
        {"table_every_4th", RungAxis::Table, "three of four angles of the table", true, true, thinnedTable, 4},
        {"table_nearest", RungAxis::Table, "interpolation between the table's angles", true, true, interpolatedBy,
         code(Interpolation::Nearest)},
        {"table_linear", RungAxis::Table, "cubic interpolation of the table", true, true, interpolatedBy,
         code(Interpolation::Linear)},

        {"lights_thousandth", RungAxis::Lights, "lights that add at most 1/1000 of white", true, true,
         withoutFaintLights, 1000},
        {"lights_fiftieth", RungAxis::Lights, "lights that add at most 1/50 of white", true, true, withoutFaintLights,
         50},

        {"one_light_colour", RungAxis::LightColour,
         "nothing but an order of products: K I is formed once for all lights", true, true, oneLightColour},

        {"one_colour_around", RungAxis::Environment, "all but the mean of the surroundings", true, true,
         oneColourAround},
        {"nine_coefficients", RungAxis::Environment, "all of the surroundings but nine spherical harmonics", true, true,
         nineCoefficients},
        {"coarse_surroundings", RungAxis::Environment, "15 of 16 texels of the surroundings", true, true,
         coarseSurroundings, 4},
    };
    return all;
}

const Rung* findRung(std::string_view id)
{
    const auto all = rungs();
    const auto found = std::find_if(all.begin(), all.end(), [id](const Rung& rung) { return id == rung.id; });
    return found == all.end() ? nullptr : &*found;
}

Applied applyRung(const Rung& rung, Recipe& recipe)
{
    if (rung.axis != RungAxis::Precision && !(recipe.onGl() ? rung.onGl : rung.onCpu))
        return {std::string("the ") + (recipe.onGl() ? "GL" : "CPU") + " renderer does not have it"};
    Recipe changed = recipe;
    Applied applied = rung.apply(rung.amount, changed);
    if (applied.skipped.empty()) {
        changed.rungs.emplace_back(rung.id);
        recipe = std::move(changed);
    }
    return applied;
}

} // namespace reflectance
