// What a model text declares about one of its uniforms. Sliders, uniform upload, command-line flags, scene keys and
// the models page are loops over these.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace reflectance {

/// float, vec3, mat3 (row by row), int (one of the declared choices) and float[] (as many numbers as a choice asks for).
enum class ParameterKind { Number, Color, Matrix, Choice, List };

/// What a list holds while its choice has this value.
struct ListForm {
    double choice = 0.0;
    std::vector<std::string> names; ///< of its numbers, in their order
};

struct Parameter {
    std::string name;    ///< as in the text, in flags and in scene files: "ks"
    std::string label;   ///< "Specular strength"
    std::string symbol;  ///< as the lecture writes it, subscripts after "_": "k_s"
    std::string unit;    ///< "" for pure numbers
    std::string tooltip; ///< one sentence
    std::string source;  ///< where it was defined or measured
    ParameterKind kind = ParameterKind::Number;
    std::size_t size = 1; ///< numbers in the flat list of values; of a list the most that it can hold
    std::vector<double>
        initial; ///< default: `size` numbers, matrices row by row; of a list as many as the default choice asks for
    double sliderMin = 0.0, sliderMax = 1.0;
    bool logarithmic = false; ///< the slider's scale
    double legalMin = -std::numeric_limits<double>::infinity();
    double legalMax = std::numeric_limits<double>::infinity();
    std::size_t offset = 0;      ///< of its first number in the model's flat list of values
    std::vector<double> choices; ///< of a Choice, ascending
    std::string chosenBy;        ///< of a List: the Choice that says how many numbers count
    std::vector<ListForm> forms; ///< of a List: one per choice

    [[nodiscard]] const ListForm* formFor(double choice) const; ///< null: no such choice
};

} // namespace reflectance
