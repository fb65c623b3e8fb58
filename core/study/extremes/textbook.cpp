#include "core/study/extremes/textbook.h"

#include "core/math/angle.h"
#include "core/math/lobe.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

template <class T> Vec3<T> textbookUnit(const Vec3<T>& v)
{
    return v / std::sqrt(dot(v, v));
}

template <class T> Vec3<T> textbookNormalized(const Vec3d& v)
{
    return textbookUnit(Vec3<T>(v));
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

/// A and B with the angles spelled out: acos, sin and tan.
template <class T>
Vec3<T> orenNayar(const Model& model, std::span<const double> values, const Vec3<T>& N, const Vec3<T>& L,
                  const Vec3<T>& V)
{
    const auto rho = numbersOf(model, values, "rho");
    const T variance = static_cast<T>(numbersOf(model, values, "sigma")[0] * numbersOf(model, values, "sigma")[0]);
    const T A = T(1) - T(0.5) * variance / (variance + T(0.33));
    const T B = T(0.45) * variance / (variance + T(0.09));
    const T angleL = std::acos(dot(N, L));
    const T angleV = std::acos(dot(N, V));
    const T azimuth = dot(textbookUnit(L - dot(N, L) * N), textbookUnit(V - dot(N, V) * N));
    const T bracket =
        A + B * std::max(T(0), azimuth) * std::sin(std::max(angleL, angleV)) * std::tan(std::min(angleL, angleV));
    return dot(N, L) * bracket * Vec3<T>(Vec3d(rho[0], rho[1], rho[2]));
}

/// D with its denominator (N.H)^2 (alpha^2 - 1) + 1 as printed.
template <class T>
Vec3<T> ggx(const Model& model, std::span<const double> values, const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V)
{
    const T square = static_cast<T>(numbersOf(model, values, "alpha")[0] * numbersOf(model, values, "alpha")[0]);
    const auto f0 = numbersOf(model, values, "f0");
    const Vec3<T> H = textbookUnit(L + V);
    const T li = dot(N, L);
    const T lv = dot(N, V);
    const T denominator = dot(N, H) * dot(N, H) * (square - T(1)) + T(1);
    const T visible = T(0.5) / (lv * std::sqrt(square + (T(1) - square) * li * li) +
                                li * std::sqrt(square + (T(1) - square) * lv * lv));
    const T grazing = std::pow(T(1) - dot(V, H), T(5));
    const Vec3<T> start(Vec3d(f0[0], f0[1], f0[2]));
    return square / (denominator * denominator) * visible * li * (start + grazing * (Vec3<T>(T(1)) - start));
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
    if (model.id() == "oren_nayar" || model.id() == "ggx")
        return dot(N, V) <= T(0)     ? Vec3<T>()
               : model.id() == "ggx" ? ggx(model, values, N, L, V) * I
                                     : orenNayar(model, values, N, L, V) * I;
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
    replace(text.code, "max(0.0, dot(L, V) - li * lv) / max(li, lv)",
            "max(0.0, dot(normalize(L - li * N), normalize(V - lv * N))) * sin(max(acos(li), acos(lv))) *\n"
            "                    tan(min(acos(li), acos(lv)))");
    replace(text.code, "dot(slant, slant) + square * (nh * nh)", "nh * nh * (square - 1.0) + 1.0");
    replace(text.code, "halfway(L, V)", "normalize(L + V)");
    replace(text.code, "vec3 shade(", "vec3 shadeUnit(");
    text.code += "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n"
                 "    return shadeUnit(normalize(textbookLength * N), normalize(textbookLength * L),\n"
                 "                     normalize(textbookLength * V), I);\n}\n";
    return textbook;
}

} // namespace

bool hasTextbookForm(const Model& model)
{
    constexpr std::string_view known[] = {"lambert", "lambert_color", "oren_nayar", "mirror", "phong", "hybrid", "ggx"};
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
