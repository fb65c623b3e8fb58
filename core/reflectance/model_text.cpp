#include "core/reflectance/model_text.h"

#include "core/base/text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace reflectance {
namespace {

/// "label    Diffuse albedo" -> {"label", "Diffuse albedo"}
std::pair<std::string_view, std::string_view> keyAndValue(std::string_view line)
{
    const std::size_t blank = std::min(line.find_first_of(" \t"), line.size());
    return {line.substr(0, blank), trimmed(line.substr(blank))};
}

struct Range {
    double low, high;
};

/// "0 .. 1e7"
std::optional<Range> parseRange(std::string_view text)
{
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos)
        return std::nullopt;
    const auto low = parseNumber(trimmed(text.substr(0, dots)));
    const auto high = parseNumber(trimmed(text.substr(dots + 2)));
    if (!low || !high)
        return std::nullopt;
    return Range{*low, *high};
}

DeclaredProperty parseProperty(std::string_view value)
{
    return {value.starts_with("yes"), std::string(value)};
}

class ModelTextParser {
public:
    ModelTextParser(std::string_view id, const std::vector<ModelText>& earlier) : earlier_(earlier)
    {
        model_.id = id;
    }

    Result<ModelText> parse(std::string_view text)
    {
        for (const std::string_view line : split(text, '\n')) {
            ++line_;
            if (!readLine(line))
                return Error{problem_, "shaders/reflectance/" + model_.id + ".glsl", line_};
        }
        if (openUniform_)
            return Error{"uniform declaration without ';'", "shaders/reflectance/" + model_.id + ".glsl", line_};
        model_.usesEnvironment = model_.code.find("vec3 shadeEnvironment(") != std::string::npos;
        model_.usesLightSize = model_.code.find("insideLight(") != std::string::npos;
        if (model_.code.find("vec3 shade(") == std::string::npos)
            return Error{"the text defines no vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)",
                         "shaders/reflectance/" + model_.id + ".glsl", line_};
        return std::move(model_);
    }

private:
    /// Uniforms and their descriptions become empty lines, so that compilers still count lines as the file does.
    bool readLine(std::string_view line)
    {
        if (line.starts_with("//!"))
            return keepLineNumber() && readModelKey(trimmed(line.substr(3)));
        if (line.starts_with("//:"))
            return keepLineNumber() && readParameterKey(trimmed(line.substr(3)));
        if (openUniform_ || line.starts_with("uniform "))
            return keepLineNumber() && readUniform(line);
        model_.code.append(line).push_back('\n');
        return true;
    }

    bool keepLineNumber()
    {
        model_.code.push_back('\n');
        return true;
    }

    bool readModelKey(std::string_view line)
    {
        const auto [key, value] = keyAndValue(line);
        if (key == "name")
            model_.name = value;
        else if (key == "formula")
            model_.formula = value;
        else if (key == "citation")
            model_.citation = value;
        else if (key == "about")
            model_.about = value;
        else if (key == "reciprocal")
            model_.reciprocal = parseProperty(value);
        else if (key == "passive")
            model_.passive = parseProperty(value);
        else if (key == "becomes")
            return readLimit(value);
        else
            return failed("unknown key //! " + std::string(key));
        return true;
    }

    /// "lambert_color where ks=0"
    bool readLimit(std::string_view value)
    {
        const auto pieces = words(value);
        if (pieces.size() != 3 || pieces[1] != "where" || pieces[2].find('=') == std::string_view::npos)
            return failed("expected: becomes MODEL where NAME=VALUE;NAME=VALUE without blanks between");
        if (!findEarlier(pieces[0]))
            return failed("becomes names no earlier model: " + std::string(pieces[0]));
        model_.becomes.push_back({std::string(pieces[0]), std::string(pieces[2])});
        return true;
    }

    bool readUniform(std::string_view line)
    {
        declaration_.append(line);
        openUniform_ = line.find(';') == std::string_view::npos;
        return openUniform_ || finishUniform();
    }

    bool finishUniform()
    {
        Parameter parameter;
        const std::size_t equals = declaration_.find('=');
        const auto head = words(std::string_view(declaration_).substr(0, equals));
        if (equals == std::string::npos || head.size() != 3)
            return failed("expected: uniform TYPE NAME = DEFAULT;");
        if (head[1] == "float")
            parameter.kind = ParameterKind::Number;
        else if (head[1] == "vec3")
            parameter.kind = ParameterKind::Color;
        else if (head[1] == "mat3")
            parameter.kind = ParameterKind::Matrix;
        else
            return failed("a parameter is a float, a vec3 or a mat3");
        parameter.name = head[2];
        parameter.label = parameter.symbol = parameter.name;
        parameter.offset = model_.valueCount();
        if (!readDefault(std::string_view(declaration_).substr(equals + 1), parameter))
            return false;
        model_.parameters.push_back(std::move(parameter));
        declaration_.clear();
        return true;
    }

    /// "0.5;", "vec3(0.04);" or "transpose(mat3(nine numbers, row by row));"
    bool readDefault(std::string_view value, Parameter& parameter)
    {
        if (parameter.kind == ParameterKind::Matrix && value.find("transpose(mat3(") == std::string_view::npos)
            return failed("write a matrix row by row: transpose(mat3(...)), since GLSL stores columns");
        const std::size_t open = value.rfind('(');
        if (open != std::string_view::npos)
            value.remove_prefix(open + 1);
        value = value.substr(0, value.find_first_of(");"));
        for (const std::string_view piece : split(value, ',')) {
            const auto number = parseNumber(trimmed(piece));
            if (!number)
                return failed("default is not a number: " + std::string(trimmed(piece)));
            parameter.initial.push_back(*number);
        }
        if (parameter.initial.size() == 1)
            parameter.initial.resize(sizeOf(parameter.kind), parameter.initial.front());
        return parameter.initial.size() == sizeOf(parameter.kind) || failed("wrong count of numbers in the default");
    }

    bool readParameterKey(std::string_view line)
    {
        if (model_.parameters.empty())
            return failed("//: describes a uniform, and none stands above");
        Parameter& parameter = model_.parameters.back();
        const auto [key, value] = keyAndValue(line);
        if (key == "label")
            parameter.label = value;
        else if (key == "symbol")
            parameter.symbol = value;
        else if (key == "unit")
            parameter.unit = value;
        else if (key == "tooltip")
            parameter.tooltip = value;
        else if (key == "source")
            parameter.source = value;
        else if (key == "slider")
            return readSlider(value, parameter);
        else if (key == "legal")
            return readLegal(value, parameter);
        else if (key == "like")
            return describeLike(value, parameter);
        else
            return failed("unknown key //: " + std::string(key));
        return true;
    }

    bool readSlider(std::string_view value, Parameter& parameter)
    {
        parameter.logarithmic = value.ends_with("log");
        if (parameter.logarithmic)
            value.remove_suffix(3);
        const auto range = parseRange(value);
        if (!range)
            return failed("expected: slider LOW .. HIGH [log]");
        parameter.sliderMin = range->low;
        parameter.sliderMax = range->high;
        return true;
    }

    bool readLegal(std::string_view value, Parameter& parameter)
    {
        const auto range = parseRange(value);
        if (!range)
            return failed("expected: legal LOW .. HIGH");
        parameter.legalMin = range->low;
        parameter.legalMax = range->high;
        return true;
    }

    bool describeLike(std::string_view id, Parameter& parameter)
    {
        const ModelText* other = findEarlier(id);
        const Parameter* twin = other ? other->find(parameter.name) : nullptr;
        if (!twin || twin->kind != parameter.kind)
            return failed("no earlier model " + std::string(id) + " with a parameter " + parameter.name);
        Parameter described = *twin;
        described.initial = parameter.initial;
        described.offset = parameter.offset;
        parameter = std::move(described);
        return true;
    }

    [[nodiscard]] const ModelText* findEarlier(std::string_view id) const
    {
        const auto named = [id](const ModelText& m) { return m.id == id; };
        const auto found = std::find_if(earlier_.begin(), earlier_.end(), named);
        return found == earlier_.end() ? nullptr : &*found;
    }

    bool failed(std::string problem)
    {
        problem_ = std::move(problem);
        return false;
    }

    const std::vector<ModelText>& earlier_;
    ModelText model_;
    std::string declaration_;
    bool openUniform_ = false;
    long line_ = 0;
    std::string problem_;
};

} // namespace

const Parameter* ModelText::find(std::string_view parameterName) const
{
    const auto named = [parameterName](const Parameter& p) { return p.name == parameterName; };
    const auto found = std::find_if(parameters.begin(), parameters.end(), named);
    return found == parameters.end() ? nullptr : &*found;
}

std::size_t ModelText::valueCount() const
{
    return parameters.empty() ? 0 : parameters.back().offset + sizeOf(parameters.back().kind);
}

Result<ModelText> parseModelText(std::string_view id, std::string_view text, const std::vector<ModelText>& earlier)
{
    return ModelTextParser(id, earlier).parse(text);
}

} // namespace reflectance
