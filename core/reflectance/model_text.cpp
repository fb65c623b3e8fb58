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
    ModelTextParser(std::string_view id, const std::vector<ModelText>& earlier, std::string_view file)
        : earlier_(earlier)
    {
        model_.id = id;
        model_.file = file.empty() ? "shaders/reflectance/" + model_.id + ".glsl" : std::string(file);
    }

    Result<ModelText> parse(std::string_view text)
    {
        for (const std::string_view line : split(text, '\n')) {
            ++line_;
            if (!readLine(line))
                return Error{problem_, model_.file, line_};
        }
        if (openUniform_)
            return Error{"uniform declaration without ';'", model_.file, line_};
        model_.usesEnvironment = model_.code.find("vec3 shadeEnvironment(") != std::string::npos;
        model_.usesLobe = model_.code.find("lobe(") != std::string::npos;
        model_.usesTable = model_.code.find("tableAt(") != std::string::npos;
        model_.usesLightSize = model_.code.find("insideLight(") != std::string::npos;
        if (model_.code.find("vec3 shade(") == std::string::npos)
            return Error{"the text defines no vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)", model_.file, line_};
        for (const Parameter& parameter : model_.parameters)
            if (!isComplete(parameter))
                return Error{problem_, model_.file, line_};
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
        else if (key == "family")
            model_.family = value;
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
        else if (key == "nonnegative")
            model_.nonnegative = parseProperty(value);
        else if (key == "becomes")
            return readLimit(value);
        else
            return failed("unknown key //! " + std::string(key));
        return true;
    }

    /// "lambert_color where ks=0", then "exactly" or "exactly facing"
    bool readLimit(std::string_view value)
    {
        const auto pieces = words(value);
        const bool exactly = pieces.size() > 3 && pieces[3] == "exactly";
        const bool facing = pieces.size() > 4 && exactly && pieces[4] == "facing";
        if (pieces.size() != (facing    ? 5U
                              : exactly ? 4U
                                        : 3U) ||
            pieces[1] != "where" || pieces[2].find('=') == std::string_view::npos)
            return failed("expected: becomes MODEL where NAME=VALUE;NAME=VALUE without blanks between, then nothing, "
                          "'exactly' or 'exactly facing'");
        if (!findEarlier(pieces[0]))
            return failed("becomes names no earlier model: " + std::string(pieces[0]));
        model_.becomes.push_back({std::string(pieces[0]), std::string(pieces[2]), exactly, facing});
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
        parameter.name = head[2];
        if (!readType(head[1], parameter))
            return false;
        parameter.label = parameter.symbol = parameter.name;
        parameter.offset = model_.valueCount();
        if (!readDefault(std::string_view(declaration_).substr(equals + 1), parameter))
            return false;
        model_.parameters.push_back(std::move(parameter));
        declaration_.clear();
        return true;
    }

    /// Kind and size; takes the brackets of "coefficients[55]" off the name.
    bool readType(std::string_view type, Parameter& parameter)
    {
        const std::size_t bracket = parameter.name.find('[');
        if (type == "float" && bracket != std::string::npos) {
            const auto size = parseInteger(split(std::string_view(parameter.name).substr(bracket + 1), ']')[0]);
            if (!size || *size < 1 || *size > 256)
                return failed("expected: uniform float NAME[COUNT] = float[](NUMBERS);");
            parameter.kind = ParameterKind::List;
            parameter.size = static_cast<std::size_t>(*size);
            parameter.name.resize(bracket);
            return true;
        }
        struct Type {
            std::string_view name;
            ParameterKind kind;
            std::size_t size;
        };
        for (const Type& known : {Type{"float", ParameterKind::Number, 1}, Type{"vec3", ParameterKind::Color, 3},
                                  Type{"mat3", ParameterKind::Matrix, 9}, Type{"int", ParameterKind::Choice, 1}})
            if (known.name == type) {
                parameter.kind = known.kind;
                parameter.size = known.size;
                return true;
            }
        return failed("a parameter is a float, a vec3, a mat3, an int or a float[]");
    }

    /// "0.5;", "vec3(0.04);" or "transpose(mat3(nine numbers, row by row));", "float[](0.5, 0.25);"
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
        if (parameter.kind == ParameterKind::List)
            return parameter.initial.size() <= parameter.size || failed("more numbers in the default than fit");
        if (parameter.initial.size() == 1)
            parameter.initial.resize(parameter.size, parameter.initial.front());
        return parameter.initial.size() == parameter.size || failed("wrong count of numbers in the default");
    }

    /// A choice has choices, the default among them; a list has a form for each choice, and its default is that of the
    /// default choice.
    bool isComplete(const Parameter& parameter)
    {
        if (parameter.kind == ParameterKind::Choice) {
            const bool known = std::find(parameter.choices.begin(), parameter.choices.end(), parameter.initial[0]) !=
                               parameter.choices.end();
            return known || failed("the default of " + parameter.name + " is not among its choices");
        }
        if (parameter.kind != ParameterKind::List)
            return true;
        const Parameter* choice = model_.find(parameter.chosenBy);
        if (!choice || parameter.forms.size() != choice->choices.size())
            return failed("the list " + parameter.name +
                          " needs one line '//: names CHOICE=VALUE ...' for each choice");
        const ListForm* form = parameter.formFor(choice->initial[0]);
        return (form && form->names.size() == parameter.initial.size()) ||
               failed("the default of " + parameter.name + " does not hold what the default " + choice->name +
                      " asks for");
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
        else if (key == "choices")
            return readChoices(value, parameter);
        else if (key == "names")
            return readNames(value, parameter);
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

    /// "2 8"
    bool readChoices(std::string_view value, Parameter& parameter)
    {
        for (const std::string_view word : words(value)) {
            const auto number = parseInteger(word);
            if (!number || parameter.kind != ParameterKind::Choice)
                return failed("expected: choices WHOLE WHOLE ... below an int");
            parameter.choices.push_back(static_cast<double>(*number));
        }
        if (parameter.choices.empty() || !std::is_sorted(parameter.choices.begin(), parameter.choices.end()))
            return failed("expected: choices in ascending order");
        parameter.sliderMin = parameter.legalMin = parameter.choices.front();
        parameter.sliderMax = parameter.legalMax = parameter.choices.back();
        return true;
    }

    /// "order=2 l0_n0_m0 l0_n2_m0": the numbers that the list holds for a choice. Further lines go on with the same choice.
    bool readNames(std::string_view value, Parameter& parameter)
    {
        auto names = words(value);
        const std::size_t equals = names.empty() ? std::string_view::npos : names[0].find('=');
        const auto choice = equals == std::string_view::npos ? std::nullopt : parseInteger(names[0].substr(equals + 1));
        if (!choice || parameter.kind != ParameterKind::List || !model_.find(names[0].substr(0, equals)))
            return failed("expected: names CHOICE=VALUE NAME NAME ... below a float[], the choice standing above");
        parameter.chosenBy = names[0].substr(0, equals);
        const auto number = static_cast<double>(*choice);
        if (parameter.forms.empty() || parameter.forms.back().choice != number)
            parameter.forms.push_back({number, {}});
        auto& all = parameter.forms.back().names;
        all.insert(all.end(), names.begin() + 1, names.end());
        return all.size() <= parameter.size || failed("more names than the list can hold");
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

const ListForm* Parameter::formFor(double choice) const
{
    const auto found =
        std::find_if(forms.begin(), forms.end(), [choice](const ListForm& f) { return f.choice == choice; });
    return found == forms.end() ? nullptr : &*found;
}

const Parameter* ModelText::find(std::string_view parameterName) const
{
    const auto named = [parameterName](const Parameter& p) { return p.name == parameterName; };
    const auto found = std::find_if(parameters.begin(), parameters.end(), named);
    return found == parameters.end() ? nullptr : &*found;
}

std::size_t ModelText::valueCount() const
{
    return parameters.empty() ? 0 : parameters.back().offset + parameters.back().size;
}

Result<ModelText> parseModelText(std::string_view id, std::string_view text, const std::vector<ModelText>& earlier,
                                 std::string_view file)
{
    return ModelTextParser(id, earlier, file).parse(text);
}

} // namespace reflectance
