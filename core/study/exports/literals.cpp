#include "core/study/exports/literals.h"

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/reflectance/lists.h"

namespace reflectance::exports {
namespace {

/// Lines of at most 110 letters that begin with "// ".
std::string remark(std::string_view text)
{
    std::string out;
    std::string line = "//";
    for (const std::string_view word : words(text)) {
        if (line.size() + 1 + word.size() > 110) {
            out += line + "\n";
            line = "//";
        }
        line += " " + std::string(word);
    }
    out += line + "\n";
    std::replace(out.begin(), out.end(), '\\', '/'); // at the end of a line it would swallow the next
    return out;
}

std::string pointed(const std::string& text)
{
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

} // namespace

std::string literal(double value)
{
    return pointed(shortest(value));
}

std::string floatLiteral(double value)
{
    return pointed(general(static_cast<double>(static_cast<float>(value)), 9));
}

std::string triple(const Vec3d& v, std::string (*one)(double))
{
    return one(v.x) + ", " + one(v.y) + ", " + one(v.z);
}

std::string codeName(std::string_view id)
{
    std::string name;
    for (const char letter : id)
        if (letter != '_' || (!name.empty() && name.back() != '_'))
            name += letter;
    while (!name.empty() && name.back() == '_')
        name.pop_back();
    const bool starts = !name.empty() && !(name[0] >= '0' && name[0] <= '9') && !name.starts_with("gl_");
    return starts ? name : "model_" + name;
}

std::string headComment(const ModelText& model, const std::vector<double>& values)
{
    std::string text = remark(model.name + ", exported by the Reflectance Explorer " + std::string(programVersion()) +
                              " (MIT licence).");
    text += "//\n" + remark("factor = " + model.formula);
    text += remark(model.citation) + "//\n";
    text +=
        remark("N, L and V are unit vectors away from the surface: normal, to the light, to the viewer; I is the light "
               "that arrives. shade gives the factor times the light, cosine included: pi times the BRDF f times N.L. "
               "Nothing is clamped.");
    const ParameterValues named = valuesByName(model, values);
    for (const Parameter& parameter : model.parameters) {
        std::vector<std::string> numbers;
        for (const double number : named.at(parameter.name))
            numbers.push_back(shortest(number));
        text += remark(parameter.name + " = " + joined(numbers, " ") +
                       (parameter.unit.empty() ? "" : " " + parameter.unit) + ": " + parameter.label +
                       (parameter.kind == ParameterKind::Matrix ? ", row by row" : ""));
    }
    return text;
}

} // namespace reflectance::exports
