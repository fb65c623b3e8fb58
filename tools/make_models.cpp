// Build step: makes C++ of the reflectance model texts.
//
//   make_models SHADER_FOLDER MODEL_LIST OUT_HEADER
//
// Each text becomes a class template whose data members are the uniforms and whose member functions are the text's
// functions (see translate.h). One that calls lobe takes its form as a second template argument.
#include "core/base/text.h"
#include "core/reflectance/model_text.h"
#include "tools/translate.h"

#include <fstream>
#include <iostream>

namespace {

using namespace reflectance;
using tools::contents;
using tools::instantiated;

std::string memberType(ParameterKind kind)
{
    constexpr const char* types[] = {"T", "Vec3<T>", "Mat3<T>", "int", "T"}; // in the order of ParameterKind
    return types[static_cast<std::size_t>(kind)];
}

std::string memberValue(const Parameter& p)
{
    const auto number = [&](std::size_t i) { return "lit<T>(values[" + std::to_string(p.offset + i) + "])"; };
    const auto triple = [&](std::size_t i) {
        return "Vec3<T>(" + number(i) + ", " + number(i + 1) + ", " + number(i + 2) + ")";
    };
    if (p.kind == ParameterKind::Number)
        return number(0);
    if (p.kind == ParameterKind::Choice)
        return "static_cast<int>(values[" + std::to_string(p.offset) + "])";
    if (p.kind == ParameterKind::List) {
        std::string numbers;
        for (std::size_t i = 0; i < p.size; ++i)
            numbers += (i > 0 ? ", " : "") + number(i);
        return numbers;
    }
    if (p.kind == ParameterKind::Color)
        return triple(0);
    return "Mat3<T>{{" + triple(0) + ", " + triple(3) + ", " + triple(6) + "}}";
}

void writeModel(std::ostream& out, const ModelText& model)
{
    out << "\ntemplate <class T" << (model.usesLobe ? ", template <class> class Lobe = ConditionedLobe" : "")
        << "> struct " << model.id << " : Frame<T>" << (model.usesLobe ? ", Lobe<T>" : "") << " {\n"
        << "    using Frame<T>::insideLight;\n    using Frame<T>::environment;\n    using Frame<T>::tableAt;\n"
        << (model.usesLobe ? "    using Lobe<T>::lobe;\n" : "");
    for (const Parameter& p : model.parameters)
        out << "    " << memberType(p.kind) << " " << p.name
            << (p.kind == ParameterKind::List ? "[" + std::to_string(p.size) + "]" : "") << ";\n";
    out << "\n    explicit " << model.id << "(const double* values)";
    const char* separator = " : ";
    for (const Parameter& p : model.parameters) {
        out << separator << p.name << "{" << memberValue(p) << "}";
        separator = ", ";
    }
    out << " {}\n\n#line 1 \"shaders/reflectance/" << model.id << ".glsl\"\n" << instantiated(model.code) << "};\n";
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
    out << "\n} // namespace reflectance::models\n\n#pragma GCC diagnostic pop\n\n#define "
           "REFLECTANCE_FOR_EACH_MODEL(DO)";
    for (const ModelText& model : models)
        out << " DO(" << model.id << ")";
    out << "\n\n#define REFLECTANCE_FOR_EACH_MODEL_WITH_LOBE(DO)";
    for (const ModelText& model : models)
        if (model.usesLobe)
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
