// The rungs by name: what each gives up and who can draw it. A surface names those that it is drawn with; what they do to a
// picture is in core/study/trade.
#pragma once

#include "core/base/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// What a rung trades. Two rungs of one axis exclude each other.
enum class RungAxis {
    Precision,
    Matrix,
    Lobe,
    Requirements,
    Model,
    Place,
    Samples,
    Resolution,
    Table,
    Lights,
    LightColour,
    Environment
};

[[nodiscard]] constexpr std::string_view nameOf(RungAxis axis)
{
    constexpr std::string_view names[] = {"precision", "colour matrix", "lobe",         "requirements",
                                          "model",     "shading place", "samples",      "resolution",
                                          "table",     "lights",        "light colour", "environment"};
    return names[static_cast<int>(axis)];
}

struct RungFacts {
    const char* id; ///< "k_diagonal"
    RungAxis axis;
    const char* about; ///< what is given up or gained, as a clause: "the off-diagonal entries of K"
    bool onCpu, onGl;  ///< which renderers have it
};

/// All rungs, by axis.
inline constexpr RungFacts rungList[] = {
    {"double", RungAxis::Precision, "nothing: the truth's own arithmetic", true, false},
    {"float", RungAxis::Precision, "9 of 16 digits", true, false},
    {"simd", RungAxis::Precision, "9 of 16 digits, in lanes", true, false},
    {"glsl", RungAxis::Precision, "9 of 16 digits, in the shader", false, true},
    {"half_buffer", RungAxis::Precision, "13 of 24 bits of the picture that is kept", false, true},

    {"k_diagonal", RungAxis::Matrix, "the off-diagonal entries of K", true, true},
    {"k_white", RungAxis::Matrix, "K but for the colour under white light", true, true},
    {"k_grey", RungAxis::Matrix, "the colour of the diffuse term", true, true},

    {"lobe_power", RungAxis::Lobe, "the lobe's conditioned form, for pow of the dot product", true, true},
    {"lobe_squarings", RungAxis::Lobe, "the lobe's conditioned form, for repeated squaring", true, true},
    {"lobe_truncated", RungAxis::Lobe, "the lobe, for (1 - n (1 - c) / k)^k", true, true},
    {"lobe_schlick", RungAxis::Lobe, "the lobe, for c / (n - n c + c)", true, true},
    {"lobe_table", RungAxis::Lobe, "the lobe, for 256 steps in sqrt(1 - c)", true, true},

    {"general_path", RungAxis::Requirements, "nothing, and nothing is left out that the scene does not require", true,
     true},

    {"no_highlight", RungAxis::Model, "the specular term", true, true},
    {"oren_nayar", RungAxis::Model, "interreflection in the grooves (the A/B form)", true, true},
    {"eon", RungAxis::Model, "Oren-Nayar's own form, for one that keeps energy", true, true},
    {"eon_polynomial", RungAxis::Model, "Oren-Nayar's own form, for EON with a polynomial", true, true},
    {"lambert", RungAxis::Model, "roughness", true, true},

    {"multisampled", RungAxis::Place, "all shadings of a triangle in a pixel but one", true, true},
    {"once_per_pixel", RungAxis::Place, "all shadings of a pixel but one", true, true},
    {"body_per_vertex", RungAxis::Place, "the diffuse term's shading but at vertices", true, false},
    {"per_vertex", RungAxis::Place, "shading but at vertices", true, false},
    {"per_face", RungAxis::Place, "shading but once per triangle", true, false},

    {"1_sample", RungAxis::Samples, "smooth edges and small highlights", true, true},
    {"4_samples", RungAxis::Samples, "samples per pixel beyond 4", true, true},
    {"9_samples", RungAxis::Samples, "samples per pixel beyond 9", true, true},
    {"16_samples", RungAxis::Samples, "samples per pixel beyond 16", true, true},
    {"25_samples", RungAxis::Samples, "samples per pixel beyond 25", true, true},
    {"36_samples", RungAxis::Samples, "samples per pixel beyond 36", true, true},
    {"49_samples", RungAxis::Samples, "samples per pixel beyond 49", true, true},
    {"64_samples", RungAxis::Samples, "samples per pixel beyond 64", true, true},

    {"half_size", RungAxis::Resolution, "three of four pixels", true, true},
    {"quarter_size", RungAxis::Resolution, "15 of 16 pixels", true, true},

    {"as_table", RungAxis::Table, "the formula, for a table of it", true, true},
    {"table_every_2nd", RungAxis::Table, "every other angle of the table", true, true},
    {"table_every_4th", RungAxis::Table, "three of four angles of the table", true, true},
    {"table_nearest", RungAxis::Table, "interpolation between the table's angles", true, true},
    {"table_linear", RungAxis::Table, "cubic interpolation of the table", true, true},

    {"lights_thousandth", RungAxis::Lights, "lights that add at most 1/1000 of white", true, true},
    {"lights_fiftieth", RungAxis::Lights, "lights that add at most 1/50 of white", true, true},

    {"one_light_colour", RungAxis::LightColour, "nothing but an order of products: K I is formed once for all lights",
     true, true},

    {"one_colour_around", RungAxis::Environment, "all but the mean of the surroundings", true, true},
    {"nine_coefficients", RungAxis::Environment, "all of the surroundings but nine spherical harmonics", true, true},
    {"coarse_surroundings", RungAxis::Environment, "15 of 16 texels of the surroundings", true, true},
};

[[nodiscard]] const RungFacts* rungNamed(std::string_view id); ///< null where no rung is named so

/// Refuses names of no rung, two of one axis, and rungs that no renderer has both of.
[[nodiscard]] Result<void> checkRungs(std::span<const std::string> rungs);

/// Whether GL draws what has these rungs; `otherwise` where both renderers could.
[[nodiscard]] bool drawnByGl(std::span<const std::string> rungs, bool otherwise);

/// With the rung taken, in the list's order, or given back where it had been taken. What excludes it goes: rungs of its axis and of
/// the other renderer.
[[nodiscard]] std::vector<std::string> toggledRung(std::span<const std::string> rungs, const RungFacts& rung);

} // namespace reflectance
