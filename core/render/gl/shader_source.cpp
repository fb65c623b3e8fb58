#include "core/render/gl/shader_source.h"

#include "core/base/embedded.h"
#include "core/base/text.h"

#include <charconv>
#include <optional>

namespace reflectance {
namespace {

const char* typeOf(ParameterKind kind)
{
    constexpr const char* types[] = {"float", "vec3", "mat3", "int", "float"}; // in the order of ParameterKind
    return types[static_cast<std::size_t>(kind)];
}

std::string declarationOf(const Parameter& parameter, const SpecialForm& form)
{
    const bool isMatrix = parameter.kind == ParameterKind::Matrix && parameter.name == "K";
    if (isMatrix && form.K == MatrixForm::Zero)
        return "const float K = 0.0;\n";
    if (isMatrix && form.K != MatrixForm::Full)
        return form.K == MatrixForm::Diagonal ? "uniform vec3 K;\n" : "uniform float K;\n";
    if (form.ks == ColorForm::One && parameter.kind == ParameterKind::Color && parameter.name == "ks")
        return "uniform float ks;\n";
    return std::string("uniform ") + typeOf(parameter.kind) + " " + parameter.name +
           (parameter.kind == ParameterKind::List ? "[" + std::to_string(parameter.size) + "]" : "") + ";\n";
}

/// Takes a whole number off the front of `text`.
std::optional<long> takeNumber(std::string_view& text)
{
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// "0:300012(5): error: ..." or "0(300012) : error ..."; nothing if the line has another form.
std::optional<Error> placed(std::string_view line, const ShaderSource& source)
{
    std::string_view rest = line;
    if (!takeNumber(rest) || rest.empty() || (rest[0] != ':' && rest[0] != '('))
        return std::nullopt;
    rest.remove_prefix(1);
    const auto number = takeNumber(rest);
    const std::size_t message = rest.find("error");
    if (!number || message == std::string_view::npos)
        return std::nullopt;
    rest.remove_prefix(message);
    const auto file = static_cast<std::size_t>(*number / linesPerFile);
    if (file == 0 || file > source.files.size())
        return std::nullopt;
    return Error{"the shader does not compile: " + std::string(trimmed(rest)), source.files[file - 1],
                 *number % linesPerFile};
}

} // namespace

ShaderPiece shaderFile(std::string_view name)
{
    return {"shaders/" + std::string(name), std::string(embeddedText(name))};
}

ShaderPiece parameterDeclarations(const ModelText& model, const SpecialForm& form)
{
    ShaderPiece piece{"parameters of " + model.id, {}};
    for (const Parameter& parameter : model.parameters)
        piece.text += declarationOf(parameter, form);
    return piece;
}

ShaderPiece modelCode(const ModelText& model)
{
    return {model.file, model.code};
}

std::vector<ShaderPiece> modelPieces(const ModelText& model, bool hasTable, LobeForm lobe, const SpecialForm& form)
{
    std::vector<ShaderPiece> pieces{shaderFile("prelude.glsl"), parameterDeclarations(model, form)};
    if (model.usesLobe) {
        pieces.push_back(shaderFile("lobe/counting.glsl"));
        pieces.push_back(shaderFile(factsOf(lobe).text));
    }
    if (model.usesTable)
        pieces.push_back(shaderFile(hasTable ? "measured/lookup.glsl" : "gl/no_table.glsl"));
    if (form.facing)
        pieces.push_back({"shaders/gl/facing.glsl", "#define shade shadeAnyViewer\n"});
    pieces.push_back(modelCode(model));
    if (form.facing)
        pieces.push_back(shaderFile("gl/facing.glsl"));
    return pieces;
}

ShaderSource assembled(const std::vector<std::string>& defines, std::vector<ShaderPiece> pieces)
{
    ShaderSource source;
    source.text = "#version 330 core\n";
    for (const std::string& name : defines)
        source.text += "#define " + name + "\n";
    for (ShaderPiece& piece : pieces) {
        source.files.push_back(std::move(piece.file));
        const long first = static_cast<long>(source.files.size()) * linesPerFile + 1;
        source.text += "#line " + std::to_string(first) + "\n" + piece.text + "\n";
    }
    return source;
}

Error compilerError(std::string_view log, const ShaderSource& source)
{
    for (const std::string_view line : split(log, '\n'))
        if (auto error = placed(line, source))
            return *std::move(error);
    return Error{"the shader does not compile: " + std::string(trimmed(log)),
                 source.files.empty() ? std::string() : source.files.back()};
}

} // namespace reflectance
