// Reads a reflectance model's text: what its comment lines declare, and its parameters.
// The same parser serves the build step (which makes C++ of the text) and the running program.
#pragma once

#include "core/base/result.h"
#include "core/reflectance/parameter.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// A property that a model declares to hold or not, with the reason in words: "no: the factor lacks the cosine".
struct DeclaredProperty {
    bool holds = false;
    std::string reason;
};

/// Another model that this one turns into for some values of its parameters.
struct DeclaredLimit {
    std::string model; ///< id of an earlier model
    std::string where; ///< "ks=0" or "K=kd", assignments separated by ";"; a name on the right is the other's parameter
    bool exactly = false; ///< equal by == in double, so that the other may stand for it; else to a few last places
    bool facing = false;  ///< but for viewers behind the surface, where this one is black
};

/// Everything that stands in shaders/reflectance/<id>.glsl.
struct ModelText {
    std::string id;       ///< file name without ending
    std::string file;     ///< for messages: "shaders/reflectance/lambert.glsl"
    std::string name;     ///< for menus
    std::string family;   ///< the heading under which menus show it
    std::string formula;  ///< in the lecture's letters
    std::string citation; ///< author, title, year
    std::string about;    ///< one paragraph for people
    DeclaredProperty reciprocal;
    DeclaredProperty passive;
    DeclaredProperty nonnegative{true, {}}; ///< a text speaks of it only where it does not hold
    std::vector<DeclaredLimit> becomes;
    std::vector<Parameter> parameters;
    bool usesEnvironment = false; ///< defines shadeEnvironment(N, V)
    bool usesLightSize = false;   ///< calls insideLight(R, V)
    bool usesLobe = false;        ///< calls lobe(R, V, n), n its parameter
    bool usesTable = false;       ///< calls tableAt(N, L, V, I): needs a measurement, its parameter `file`
    std::string code;             ///< the GLSL text without uniform declarations, line numbers kept

    [[nodiscard]] const Parameter* find(std::string_view parameterName) const;
    [[nodiscard]] std::size_t valueCount() const; ///< numbers in the flat list of values
};

/// Parses one text. `earlier` resolves "//: like ID", which takes a parameter's description over from another model.
/// `file` is named in messages; empty: where built-in texts stand.
[[nodiscard]] Result<ModelText> parseModelText(std::string_view id, std::string_view text,
                                               const std::vector<ModelText>& earlier, std::string_view file = {});

} // namespace reflectance
