// Build step: makes C++ of the reflectance model texts.
//
//   make_models SHADER_FOLDER MODEL_LIST OUT_HEADER
//
// Each text becomes a class template whose data members are the uniforms and whose member functions are the text's
// functions (see core/reflectance/cpp_text.h). One that calls lobe takes its form as a second template argument.
#include "core/base/text.h"
#include "core/reflectance/cpp_text.h"
#include "core/reflectance/model_text.h"
#include "tools/contents.h"

#include <algorithm>
#include <fstream>
#include <iostream>

namespace {

using namespace reflectance;
using tools::contents;

/// ks, which has a form of its own where it is one number: see special_form.h.
bool isHeight(const Parameter& p)
{
    return p.kind == ParameterKind::Color && p.name == "ks";
}

std::string memberType(const Parameter& p)
{
    constexpr const char* types[] = {"T", "Vec3<T>", "Matrix", "int", "T"}; // in the order of ParameterKind
    return isHeight(p) ? "Height" : types[static_cast<std::size_t>(p.kind)];
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
    if (isHeight(p))
        return "colorFrom<T, Height>(values + " + std::to_string(p.offset) + ")";
    if (p.kind == ParameterKind::Color)
        return triple(0);
    return "matrixFrom<T, Matrix>(values + " + std::to_string(p.offset) + ")";
}

void writeModel(std::ostream& out, const ModelText& model)
{
    out << "\ntemplate <class T, template <class> class Lobe = ConditionedLobe, class Matrix = Mat3<T>, class Height = "
           "Vec3<T>>\n"
        << "struct " << model.id << " : Frame<T>" << (model.usesLobe ? ", Lobe<T>" : "") << " {\n"
        << "    using Frame<T>::insideLight;\n    using Frame<T>::environment;\n    using Frame<T>::tableAt;\n"
        << (model.usesLobe ? "    using Lobe<T>::lobe;\n" : "");
    for (const Parameter& p : model.parameters)
        out << "    " << memberType(p) << " " << p.name
            << (p.kind == ParameterKind::List ? "[" + std::to_string(p.size) + "]" : "") << ";\n";
    out << "\n    explicit " << model.id << "(const double* values)";
    const char* separator = " : ";
    for (const Parameter& p : model.parameters) {
        out << separator << p.name << "{" << memberValue(p) << "}";
        separator = ", ";
    }
    out << " {}\n\n#line 1 \"shaders/reflectance/" << model.id << ".glsl\"\n" << instantiated(model.code) << "};\n";
}

/// "DO(hybrid, Diagonal, One, false)" for each special form of the model that has kernels of its own. Those that a declared
/// limit leads elsewhere are left out: lambert_color with a grey K runs as lambert.
void writeSpecials(std::ostream& out, const ModelText& model)
{
    const auto write = [&](const char* K, const char* ks, bool facing) {
        out << " DO(" << model.id << ", MatrixForm::" << K << ", ColorForm::" << ks << ", "
            << (facing ? "true" : "false") << ")";
    };
    const bool hasMatrix = model.find("K") != nullptr;
    const bool hasBlackLimit = std::any_of(model.becomes.begin(), model.becomes.end(), [](const DeclaredLimit& limit) {
        return limit.exactly && limit.where == "K=0";
    });
    const bool hasHeight = model.find("ks") != nullptr && isHeight(*model.find("ks"));
    if (model.id == "lambert")
        write("Full", "Three", true);
    if (model.id == "lambert_color") {
        write("Diagonal", "Three", false);
        write("Diagonal", "Three", true);
        write("Full", "Three", true);
    } else if (hasHeight) {
        write("Full", "One", false);
        for (const char* K : {"Diagonal", "Grey", "Zero"})
            for (const char* ks : {"Three", "One"})
                if (hasMatrix && !(hasBlackLimit && K == std::string_view("Zero")))
                    write(K, ks, false);
    }
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
           "#include \"core/reflectance/frame.h\"\n#include \"core/reflectance/special_types.h\"\n\n"
           "#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n\n"
           "namespace reflectance::models {\n";
    for (const ModelText& model : models)
        writeModel(out, model);
    out << "\n} // namespace reflectance::models\n\n#pragma GCC diagnostic pop\n\n#define "
           "REFLECTANCE_FOR_EACH_MODEL(DO)";
    for (const ModelText& model : models)
        out << " DO(" << model.id << ")";
    out << "\n\n#define REFLECTANCE_FOR_EACH_SPECIAL(DO)";
    for (const ModelText& model : models)
        writeSpecials(out, model);
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
