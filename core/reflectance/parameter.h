// What a model text declares about one of its uniforms. Sliders, uniform upload, command-line flags, scene keys and
// the models page are loops over these.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace reflectance {

/// How many numbers a parameter holds: float 1, vec3 3, mat3 9 (row by row).
enum class ParameterKind { Number, Color, Matrix };

[[nodiscard]] constexpr std::size_t sizeOf(ParameterKind kind)
{
    return kind == ParameterKind::Number ? 1 : kind == ParameterKind::Color ? 3 : 9;
}

struct Parameter {
    std::string name;    ///< as in the text, in flags and in scene files: "ks"
    std::string label;   ///< "Specular strength"
    std::string symbol;  ///< as the lecture writes it, subscripts after "_": "k_s"
    std::string unit;    ///< "" for pure numbers
    std::string tooltip; ///< one sentence
    std::string source;  ///< where it was defined or measured
    ParameterKind kind = ParameterKind::Number;
    std::vector<double> initial; ///< default, sizeOf(kind) numbers, matrices row by row
    double sliderMin = 0.0, sliderMax = 1.0;
    bool logarithmic = false; ///< the slider's scale
    double legalMin = -std::numeric_limits<double>::infinity();
    double legalMax = std::numeric_limits<double>::infinity();
    std::size_t offset = 0; ///< of its first number in the model's flat list of values
};

} // namespace reflectance
