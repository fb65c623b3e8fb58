#include "core/study/extremes/textbook.h"

#include "core/math/angle.h"
#include "core/math/lobe.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

template <class T> Vec3<T> textbookNormalized(const Vec3d& v)
{
    const Vec3<T> rounded(v);
    return rounded / std::sqrt(dot(rounded, rounded));
}

/// The values of one parameter, or nothing.
std::span<const double> numbersOf(const Model& model, std::span<const double> values, std::string_view name)
{
    const Parameter* parameter = model.text.find(name);
    return parameter ? values.subspan(parameter->offset, parameter->size) : std::span<const double>();
}

/// kd I or K I; 0 for a model without either.
template <class T> Vec3<T> diffuse(const Model& model, std::span<const double> values, const Vec3<T>& I)
{
    if (const auto kd = numbersOf(model, values, "kd"); !kd.empty())
        return static_cast<T>(kd[0]) * I;
    Mat3<T> matrix;
    if (const auto K = numbersOf(model, values, "K"); !K.empty())
        for (std::size_t row = 0; row < 3; ++row)
            matrix.rows[row] = Vec3<T>(Vec3d(K[3 * row], K[3 * row + 1], K[3 * row + 2]));
    return matrix * I;
}

template <class T>
Vec3<T> shaded(const Model& model, std::span<const double> values, const Observation& row, const ObservedLight& light)
{
    const Vec3<T> N = textbookNormalized<T>(row.N);
    const Vec3<T> L = textbookNormalized<T>(light.L);
    const Vec3<T> V = textbookNormalized<T>(row.V);
    const Vec3<T> I(light.I);
    const T cosine = dot(N, L);
    if (cosine <= T(0)) // NaN goes on, as it does in programs that clamp with max
        return {};
    const T reflected = dot(mirrored(N, L), V);
    if (const auto reflectance = numbersOf(model, values, "reflectance"); !reflectance.empty())
        return reflected > T(1) - static_cast<T>(0.5 * squaredChord(light.radius)) ? static_cast<T>(reflectance[0]) * I
                                                                                   : Vec3<T>();
    Vec3<T> sum = cosine * diffuse(model, values, I);
    if (const auto ks = numbersOf(model, values, "ks"); !ks.empty())
        sum += std::pow(std::max(reflected, T(0)), static_cast<T>(numbersOf(model, values, "n")[0])) *
               Vec3<T>(Vec3d(ks[0], ks[1], ks[2])) * I;
    return sum;
}

template <class T>
std::vector<Vec3d> evaluated(const Model& model, std::span<const double> values, std::span<const Observation> rows)
{
    std::vector<Vec3d> results;
    for (const Observation& row : rows) {
        Vec3<T> sum;
        for (const ObservedLight& light : row.lights)
            sum += shaded<T>(model, values, row, light);
        results.emplace_back(sum);
    }
    return results;
}

void replace(std::string& text, std::string_view from, std::string_view to)
{
    if (const std::size_t at = text.find(from); at != std::string::npos)
        text.replace(at, from.size(), to);
}

/// The model's own text with the prelude's careful functions replaced by what a textbook writes.
Model inGlsl(const Model& model)
{
    Model textbook = model;
    ModelText& text = textbook.text;
    text.id += "_textbook";
    Parameter length;
    length.name = "textbookLength";
    length.initial = {1.0};
    length.offset = text.valueCount();
    text.parameters.push_back(length);
    replace(text.code, "lobe(mirrored(N, L), V, n)", "pow(max(dot(mirrored(N, L), V), 0.0), n)");
    replace(text.code, "insideLight(mirrored(N, L), V)", "gate(dot(mirrored(N, L), V) - (1.0 - 0.5 * lightDisc), 1.0)");
    replace(text.code, "vec3 shade(", "vec3 shadeUnit(");
    text.code += "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n"
                 "    return shadeUnit(normalize(textbookLength * N), normalize(textbookLength * L),\n"
                 "                     normalize(textbookLength * V), I);\n}\n";
    return textbook;
}

} // namespace

bool hasTextbookForm(const Model& model)
{
    constexpr std::string_view known[] = {"lambert", "lambert_color", "mirror", "phong", "hybrid"};
    return std::ranges::count(known, model.id()) > 0;
}

Instruments textbookInstruments(const Instruments& ours)
{
    Instruments textbook = ours;
    textbook.evaluate = [ours](const Model& model, std::span<const double> values, std::span<const Observation> rows,
                               Precision precision) -> Result<std::vector<Vec3d>> {
        if (!hasTextbookForm(model))
            return ours.evaluate(model, values, rows, precision);
        if (precision == Precision::Double)
            return evaluated<double>(model, values, rows);
        if (precision != Precision::Glsl)
            return evaluated<float>(model, values, rows);
        std::vector<double> withLength(values.begin(), values.end());
        withLength.push_back(rows.empty() ? 1.0 : length(rows.front().N));
        return ours.evaluate(inGlsl(model), withLength, rows, precision);
    };
    return textbook;
}

} // namespace reflectance
