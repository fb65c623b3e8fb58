// Build step: makes C++ of the reflectance model texts.
//
//   make_models SHADER_FOLDER MODEL_LIST OUT_HEADER
//
// Each text becomes a class template whose data members are the uniforms and whose member functions are the text's
// functions, with T for float, Vec3<T> for vec3, Mat3<T> for mat3 and lit<T>(0.33) for literals. #line keeps errors,
// coverage and debuggers in the .glsl file.
#include "core/base/text.h"
#include "core/reflectance/model_text.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using namespace reflectance;

bool isWordLetter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Length of the number literal at `at`, 0 if none starts there.
std::size_t numberLength(std::string_view code, std::size_t at)
{
    const auto digit = [&](std::size_t i) { return i < code.size() && std::isdigit(static_cast<unsigned char>(code[i])) != 0; };
    if (!digit(at) && !(code[at] == '.' && digit(at + 1)))
        return 0;
    std::size_t end = at;
    while (digit(end) || (end < code.size() && code[end] == '.'))
        ++end;
    if (end < code.size() && (code[end] == 'e' || code[end] == 'E')) {
        const std::size_t sign = (code[end + 1] == '-' || code[end + 1] == '+') ? 1 : 0;
        for (end += 1 + sign; digit(end);)
            ++end;
    }
    return end - at;
}

std::string typeNamed(std::string_view word)
{
    if (word == "float")
        return "T";
    if (word == "vec3")
        return "Vec3<T>";
    if (word == "mat3")
        return "Mat3<T>";
    return std::string(word);
}

std::string instantiated(std::string_view code)
{
    std::string out;
    for (std::size_t i = 0; i < code.size();) {
        if (code.substr(i, 2) == "//") {
            i = std::min(code.find('\n', i), code.size());
        } else if (const std::size_t length = numberLength(code, i)) {
            out.append("lit<T>(").append(code.substr(i, length)).append(")");
            i += length;
        } else if (isWordLetter(code[i])) {
            std::size_t end = i;
            while (end < code.size() && isWordLetter(code[end]))
                ++end;
            out += typeNamed(code.substr(i, end - i));
            i = end;
        } else {
            out.push_back(code[i++]);
        }
    }
    return out;
}

std::string memberType(ParameterKind kind)
{
    return kind == ParameterKind::Number ? "T" : kind == ParameterKind::Color ? "Vec3<T>" : "Mat3<T>";
}

std::string memberValue(const Parameter& p)
{
    const auto number = [&](std::size_t i) { return "lit<T>(values[" + std::to_string(p.offset + i) + "])"; };
    const auto triple = [&](std::size_t i) { return "Vec3<T>(" + number(i) + ", " + number(i + 1) + ", " + number(i + 2) + ")"; };
    if (p.kind == ParameterKind::Number)
        return number(0);
    if (p.kind == ParameterKind::Color)
        return triple(0);
    return "Mat3<T>{{" + triple(0) + ", " + triple(3) + ", " + triple(6) + "}}";
}

void writeModel(std::ostream& out, const ModelText& model)
{
    out << "\ntemplate <class T> struct " << model.id << " : Frame<T> {\n"
        << "    using Frame<T>::insideLight;\n    using Frame<T>::environment;\n";
    for (const Parameter& p : model.parameters)
        out << "    " << memberType(p.kind) << " " << p.name << ";\n";
    out << "\n    explicit " << model.id << "(const double* values)";
    const char* separator = " : ";
    for (const Parameter& p : model.parameters) {
        out << separator << p.name << "(" << memberValue(p) << ")";
        separator = ", ";
    }
    out << " {}\n\n#line 1 \"shaders/reflectance/" << model.id << ".glsl\"\n" << instantiated(model.code) << "};\n";
}

std::string contents(const std::string& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

int run(const std::string& folder, const std::string& list, const std::string& header)
{
    std::vector<ModelText> models;
    const std::string listText = contents(list);
    for (const std::string_view line : split(listText, '\n')) {
        if (line.empty() || line.front() == '#')
            continue;
        auto model = parseModelText(line, contents(folder + "/" + std::string(line) + ".glsl"), models);
        if (!model) {
            std::cerr << model.error().sentence() << '\n';
            return 1;
        }
        models.push_back(*std::move(model));
    }
    std::ofstream out(header);
    out << "// Made by tools/make_models from shaders/reflectance; do not edit.\n#pragma once\n\n"
           "#include \"core/reflectance/frame.h\"\n\n"
           "#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n\n"
           "namespace reflectance::models {\n";
    for (const ModelText& model : models)
        writeModel(out, model);
    out << "\n} // namespace reflectance::models\n\n#pragma GCC diagnostic pop\n\n#define REFLECTANCE_FOR_EACH_MODEL(DO)";
    for (const ModelText& model : models)
        out << " DO(" << model.id << ")";
    out << '\n';
    return out.good() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 4) {
        std::cerr << "usage: make_models SHADER_FOLDER MODEL_LIST OUT_HEADER\n";
        return 2;
    }
    return run(argv[1], argv[2], argv[3]);
}
