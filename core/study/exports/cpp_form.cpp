#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/reflectance/cpp_text.h"
#include "core/study/exports/forms.h"
#include "core/study/exports/literals.h"
#include "core/study/exports/test_vectors.h"

#include <utility>

namespace reflectance {

std::span<const EmbeddedFile> exportedHeaders(); // made by cmake/Embed.cmake

namespace exports {
namespace {

/// What C++17 does not have yet, and what stands in its place.
constexpr std::pair<std::string_view, std::string_view> substitutes[] = {
    {"std::numbers::pi", "3.141592653589793"},
    {"std::numbers::log2e", "1.4426950408889634"},
    {"std::bit_cast<", "bitCast<"},
};
constexpr std::string_view bitCast =
    "template <class To, class From> [[nodiscard]] constexpr To bitCast(const From& from)\n"
    "{\n    return __builtin_bit_cast(To, from); // GCC 11, Clang 9, Visual C++ 19.27\n}\n\n";

/// A header of core/math without its frame: what is included of the standard library stands above all of them.
std::string flattened(std::string_view header)
{
    std::string out;
    for (const std::string_view line : split(header, '\n'))
        if (!line.starts_with("#") && !line.starts_with("namespace reflectance") &&
            !line.starts_with("} // namespace reflectance"))
            out += std::string(line) + "\n";
    for (const auto& [name, substitute] : substitutes)
        for (std::size_t at = out.find(name); at != std::string::npos; at = out.find(name, at + substitute.size()))
            out.replace(at, name.size(), substitute);
    return std::string(trimmed(out)) + "\n\n";
}

std::string upper(std::string text)
{
    for (char& letter : text)
        if (letter >= 'a' && letter <= 'z')
            letter = static_cast<char>(letter - 'a' + 'A');
    return text;
}

std::string supportText()
{
    std::string text(bitCast);
    for (const EmbeddedFile& file : exportedHeaders())
        text += flattened(file.bytes);
    return text;
}

std::string memberOf(const Parameter& p, const std::vector<double>& values)
{
    const auto number = [&](std::size_t i) { return "lit<T>(" + literal(values[p.offset + i]) + ")"; };
    const auto row = [&](std::size_t i) {
        return "Vec3<T>(" + number(i) + ", " + number(i + 1) + ", " + number(i + 2) + ")";
    };
    switch (p.kind) {
    case ParameterKind::Number:
        return "    T " + p.name + " = " + number(0) + ";\n";
    case ParameterKind::Color:
        return "    Vec3<T> " + p.name + " = " + row(0) + ";\n";
    case ParameterKind::Matrix:
        return "    Mat3<T> " + p.name + " = {{" + row(0) + ",\n        " + row(3) + ",\n        " + row(6) + "}};\n";
    case ParameterKind::Choice:
        return "    int " + p.name + " = " + std::to_string(static_cast<int>(values[p.offset])) + ";\n";
    case ParameterKind::List:
        break;
    }
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < p.size; ++i)
        numbers.push_back(number(i));
    return "    T " + p.name + "[" + std::to_string(p.size) + "] = {" + joined(numbers) + "};\n";
}

/// What a text may ask of its frame, where it asks for it.
std::string frameOf(const ModelText& model)
{
    std::string text;
    if (model.usesLightSize)
        text += "    T lightDisc{}; ///< (2 sin(a/2))^2 of the light's angular radius a\n\n"
                "    T insideLight(const Vec3<T>& R, const Vec3<T>& V) const\n    {\n"
                "        const Vec3<T> chord = R - V;\n        return gate(lightDisc - dot(chord, chord), "
                "lit<T>(1.0));\n    }\n\n";
    if (occurrences("environment", model.code) > 0)
        text += "    Vec3<T> (*surroundings)(const Vec3<T>& direction) = nullptr; ///< what a mirror sees; null: "
                "nothing\n\n"
                "    Vec3<T> environment(const Vec3<T>& direction) const\n    {\n"
                "        return surroundings ? surroundings(direction) : Vec3<T>();\n    }\n\n";
    // GLSL's functions that only texts of one's own call.
    if (occurrences("length", model.code) > 0 || occurrences("normalize", model.code) > 0)
        text += "    static T length(const Vec3<T>& a) { return sqrt(dot(a, a)); }\n"
                "    static Vec3<T> normalize(const Vec3<T>& a) { return a / length(a); }\n";
    if (occurrences("sign", model.code) > 0)
        text += "    static T sign(T a) { return a > T(0) ? T(1) : a < T(0) ? T(-1) : T(0); }\n";
    for (const char* name : {"exp", "log", "sin", "cos", "tan", "asin", "acos"})
        if (occurrences(name, model.code) > 0)
            text += std::string("    static T ") + name + "(T a) { return std::" + name + "(a); }\n";
    if (occurrences("atan", model.code) > 0)
        text += "    static T atan(T a) { return std::atan(a); }\n"
                "    static T atan(T a, T b) { return std::atan2(a, b); }\n";
    return text;
}

std::string vectorsText(const std::vector<TestVector>& vectors)
{
    std::string text = "struct TestVector {\n    double N[3], L[3], V[3], I[3], lightDisc, expected[3];\n"
                       "    double inDouble[3], inFloat[3]; ///< how far each arithmetic may be off\n};\n\n"
                       "inline constexpr TestVector testVectors[] = {\n";
    for (const TestVector& v : vectors) {
        const auto three = [](const Vec3d& a) { return "{" + triple(a, literal) + "}"; };
        text += "    {" + three(v.N) + ", " + three(v.L) + ", " + three(v.V) + ", " + three(v.I) + ",\n     " +
                literal(squaredChord(v.lightRadius)) + ", " + three(v.expected) + ",\n     " +
                three(toleranceOf(v, 0x1p-53)) + ", " + three(toleranceOf(v, 0x1p-24)) + "},\n";
    }
    return text + "};\n\n";
}

std::string selfTestText(const ModelText& model)
{
    return std::string(
               "/// How many of the test vectors are further from what double gave than T may be: 0 where all is "
               "well.\n"
               "template <class T = double> inline int selfTest()\n{\n    Model<T> model;\n    int failed = 0;\n"
               "    const auto vec = [](const double (&v)[3]) { return Vec3<T>(T(v[0]), T(v[1]), T(v[2])); };\n"
               "    for (const TestVector& test : testVectors) {\n") +
           (model.usesLightSize ? "        model.lightDisc = T(test.lightDisc);\n" : "") +
           "        const Vec3<T> got = model.shade(vec(test.N), vec(test.L), vec(test.V), vec(test.I));\n"
           "        const double channels[3] = {double(got.x), double(got.y), double(got.z)};\n"
           "        bool holds = true;\n        for (int i = 0; i < 3; ++i)\n"
           "            holds = holds && std::fabs(channels[i] - test.expected[i]) <=\n"
           "                                 (sizeof(T) < sizeof(double) ? test.inFloat[i] : test.inDouble[i]);\n"
           "        failed += holds ? 0 : 1;\n    }\n    return failed;\n}\n";
}

} // namespace

std::string cppForm(const ExportSubject& subject)
{
    const ModelText& model = subject.model->text;
    const std::string space = "reflectance_" + codeName(model.id);
    const std::string guard = "REFLECTANCE_EXPORTED_" + upper(codeName(model.id)) + "_H";
    std::string text = headComment(model, subject.values) + "//\n// In double or float:  " + space +
                       "::Model<double> model;  " + "model.shade(N, L, V, I);  " + space +
                       "::selfTest() is 0 where all is well.\n" +
                       "// To check this file alone: c++ -std=c++17 -x c++ -DREFLECTANCE_SELF_TEST FILE && ./a.out\n"
                       "#ifndef " +
                       guard + "\n#define " + guard +
                       "\n\n#include <algorithm>\n#include <array>\n#include <cmath>\n#include <cstdint>\n#include "
                       "<limits>\n\nnamespace " +
                       space + " {\n\n" + supportText() + "template <class T> struct Model {\n";
    for (const Parameter& parameter : model.parameters)
        text += memberOf(parameter, subject.values);
    text += frameOf(model) + "\n" + instantiated(std::string(trimmed(model.code)) + "\n", true) + "};\n\n" +
            vectorsText(testVectors(*subject.model, subject.values, subject.measured)) + selfTestText(model) +
            "\n} // namespace " + space + "\n\n#ifdef REFLECTANCE_SELF_TEST\nint main() { return " + space +
            "::selfTest<double>() + " + space + "::selfTest<float>(); }\n#endif\n#endif\n";
    return text;
}

} // namespace exports
} // namespace reflectance
