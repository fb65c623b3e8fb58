#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/study/exports/forms.h"
#include "core/study/exports/literals.h"
#include "core/study/exports/test_vectors.h"

#include <set>

namespace reflectance::exports {
namespace {

/// "const vec3 ks = vec3(0.5, 0.5, 0.5);"
std::string constantOf(const Parameter& p, const std::vector<double>& values)
{
    const auto number = [&](std::size_t i) { return floatLiteral(values[p.offset + i]); };
    const auto list = [&](const std::vector<std::size_t>& order) {
        std::vector<std::string> numbers;
        for (const std::size_t i : order)
            numbers.push_back(number(i));
        return joined(numbers);
    };
    switch (p.kind) {
    case ParameterKind::Number:
        return "const float " + p.name + " = " + number(0) + ";\n";
    case ParameterKind::Color:
        return "const vec3 " + p.name + " = vec3(" + list({0, 1, 2}) + ");\n";
    case ParameterKind::Matrix: // columns, as GLSL has them
        return "const mat3 " + p.name + " = mat3(" + list({0, 3, 6, 1, 4, 7, 2, 5, 8}) + ");\n";
    case ParameterKind::Choice:
        return "const int " + p.name + " = " + std::to_string(static_cast<int>(values[p.offset])) + ";\n";
    case ParameterKind::List:
        break;
    }
    std::vector<std::size_t> all(p.size);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    return "const float " + p.name + "[" + std::to_string(p.size) + "] = float[](" + list(all) + ");\n";
}

/// The names that the code defines at file scope: "float lobe(" and "const float pi = ".
std::set<std::string, std::less<>> definedIn(std::string_view code)
{
    std::set<std::string, std::less<>> names;
    for (std::string_view line : split(code, '\n')) {
        if (line.starts_with("const "))
            line.remove_prefix(6);
        for (const std::string_view type : {"float ", "vec3 ", "mat3 ", "int ", "bool "})
            if (line.starts_with(type)) {
                const std::string_view rest = line.substr(type.size());
                std::size_t end = 0;
                while (end < rest.size() && isWordLetter(rest[end]))
                    ++end;
                names.emplace(rest.substr(0, end));
            }
    }
    return names;
}

std::string arrayOf(const char* name, const std::vector<TestVector>& vectors, Vec3d (*of)(const TestVector&))
{
    const std::string count = std::to_string(vectors.size());
    std::string text = std::string("const vec3 ") + name + "[" + count + "] = vec3[](";
    const char* separator = "\n    ";
    for (const TestVector& v : vectors) {
        text += separator + ("vec3(" + triple(of(v), floatLiteral) + ")");
        separator = ",\n    ";
    }
    return text + ");\n";
}

std::string selfTest(const std::vector<TestVector>& vectors)
{
    std::string text = "// How many of the test vectors are further from what double gives than a float may be: 0 "
                       "where all is well.\n";
    text += arrayOf("testN", vectors, [](const TestVector& v) { return v.N; });
    text += arrayOf("testL", vectors, [](const TestVector& v) { return v.L; });
    text += arrayOf("testV", vectors, [](const TestVector& v) { return v.V; });
    text += arrayOf("testI", vectors, [](const TestVector& v) { return v.I; });
    text += arrayOf("testExpected", vectors, [](const TestVector& v) { return v.expected; });
    text += arrayOf("testTolerance", vectors, [](const TestVector& v) { return toleranceOf(v, 0x1p-24); });
    text +=
        "int selfTest()\n{\n    int failed = 0;\n    float disc = lightDisc;\n    lightDisc = " +
        floatLiteral(squaredChord(vectors.front().lightRadius)) + ";\n    for (int i = 0; i < " +
        std::to_string(vectors.size()) +
        "; ++i) {\n"
        "        vec3 off = abs(shade(testN[i], testL[i], testV[i], testI[i]) - testExpected[i]);\n"
        "        if (!(off.x <= testTolerance[i].x && off.y <= testTolerance[i].y && off.z <= testTolerance[i].z))\n"
        "            ++failed;\n    }\n    lightDisc = disc;\n    return failed;\n}\n";
    return text;
}

} // namespace

std::string glslForm(const ExportSubject& subject)
{
    const ModelText& model = subject.model->text;
    std::string code(embeddedText("prelude.glsl"));
    if (model.usesLobe)
        code += "\n" + std::string(embeddedText(factsOf(LobeForm::Conditioned).text));
    code += model.usesEnvironment ? "\n// What a mirror sees: put your own in its place.\n" : "\n";
    code += "vec3 environment(vec3 direction) { return vec3(0.0); }\n\n// The parameters; make uniforms of those that "
            "shall change.\n";
    for (const Parameter& parameter : model.parameters)
        code += constantOf(parameter, subject.values);
    code += "\n" + std::string(trimmed(model.code)) + "\n\n" +
            selfTest(testVectors(*subject.model, subject.values, subject.measured));
    const auto defined = definedIn(code);
    const std::string prefix = codeName(model.id) + "_";
    return headComment(model, subject.values) +
           "//\n// Paste it below your #version line (GLSL 3.30, or 3.00 es with precision highp float). All names "
           "begin with " +
           prefix + "\n// Call " + prefix + "shade(N, L, V, I); " + prefix +
           "selfTest() is 0 where this compiler and driver keep the tolerance.\n\n" +
           withNames(code, [&](std::string_view word) {
               return defined.contains(word) ? prefix + std::string(word) : std::string(word);
           });
}

} // namespace reflectance::exports
