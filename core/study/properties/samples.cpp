#include "core/study/properties/samples.h"

#include "core/math/lobe.h"
#include "core/reflectance/lists.h"
#include "core/study/properties/basis.h"

#include <algorithm>
#include <numbers>

namespace reflectance::properties {
namespace {

/// The i-th of evenly spread numbers in 0 .. 1, independent for each dimension: multiples of the root of a prime.
double spreadOut(std::size_t i, std::size_t dimension)
{
    constexpr double primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
    const double step = std::sqrt(primes[dimension % std::size(primes)]);
    const std::size_t later = dimension / std::size(primes); // beyond 16 dimensions the same roots, one step on
    const double value = static_cast<double>(i + 1 + later) * step;
    return value - std::floor(value);
}

double onSlider(const Parameter& p, double share)
{
    if (!p.logarithmic)
        return p.sliderMin + share * (p.sliderMax - p.sliderMin);
    // The ends are exact, which exp(log(x)) is not.
    if (share == 0.0 || share == 1.0)
        return share == 0.0 ? p.sliderMin : p.sliderMax;
    return p.sliderMin * std::pow(p.sliderMax / p.sliderMin, share);
}

using Numbers = std::vector<double>;

Numbers timesDefault(const Parameter& p, double factor)
{
    Numbers numbers = p.initial;
    std::transform(numbers.begin(), numbers.end(), numbers.begin(), [factor](double v) { return factor * v; });
    return numbers;
}

/// Landmarks of one parameter; the first is its low end, the last its high end.
std::vector<Numbers> landmarks(const Parameter& p)
{
    if (p.kind == ParameterKind::Matrix) {
        const double third = 1.0 / 3.0;
        return {Numbers(9, 0.0), Numbers(9, third), {0, 1, 0, 0, 0, 1, 1, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    }
    if (p.kind == ParameterKind::Choice) {
        std::vector<Numbers> found;
        for (const double choice : p.choices)
            found.push_back({choice});
        return found;
    }
    if (p.kind == ParameterKind::List)
        return {timesDefault(p, -1.0), p.initial, timesDefault(p, 2.0)};
    std::vector<Numbers> found;
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
        found.emplace_back(p.size, onSlider(p, share));
    if (p.kind == ParameterKind::Color)
        found.insert(found.begin() + 1, {p.sliderMax, p.sliderMin, onSlider(p, 0.5)});
    return found;
}

Numbers interiorPoint(const Parameter& p, std::size_t i)
{
    if (p.kind == ParameterKind::Choice)
        return {p.choices[i % p.choices.size()]};
    if (p.kind == ParameterKind::List)
        return timesDefault(p, 3.0 * spreadOut(i, p.offset) - 1.0);
    Numbers numbers;
    for (std::size_t k = 0; k < p.size; ++k)
        numbers.push_back(spreadOut(i, p.offset + k));
    if (p.kind != ParameterKind::Matrix) {
        std::transform(numbers.begin(), numbers.end(), numbers.begin(), [&](double u) { return onSlider(p, u); });
        return numbers;
    }
    for (std::size_t row = 0; row < 9; row += 3) {
        const double sum = numbers[row] + numbers[row + 1] + numbers[row + 2];
        const double share = spreadOut(i, p.offset + 9 + row) / sum;
        for (std::size_t k = row; k < row + 3; ++k)
            numbers[k] *= share;
    }
    return numbers;
}

void put(const Parameter& p, const Numbers& numbers, Numbers& flat)
{
    std::copy(numbers.begin(), numbers.end(), flat.begin() + static_cast<std::ptrdiff_t>(p.offset));
}

Numbers defaults(const ModelText& model)
{
    return flatValues(model, {});
}

/// Lists were put in the form of the default choice; here they take that of the choice beside them.
Numbers withListsInForm(const ModelText& model, Numbers flat)
{
    for (const Parameter& p : model.parameters) {
        if (p.kind != ParameterKind::List)
            continue;
        const auto first = flat.begin() + static_cast<std::ptrdiff_t>(p.offset);
        const Numbers numbers(first, first + static_cast<std::ptrdiff_t>(p.initial.size()));
        std::fill(first, first + static_cast<std::ptrdiff_t>(p.size), 0.0);
        put(p, inForm(p, numbers, *p.formFor(flat[model.find(p.chosenBy)->offset])), flat);
    }
    return flat;
}

constexpr Vec3d normals[] = {{0, 0, 1}, {0.6, 0, 0.8}, {-0.48, 0.6, 0.64}, {1, 0, 0}, {0.36, -0.8, -0.48}};

/// 0 to 89.94 degrees, denser towards the horizon.
double polarAngle(double share)
{
    return std::acos(smallestCosine) * (1.0 - (1.0 - share) * (1.0 - share));
}

Directions litSample(std::size_t i)
{
    const Vec3d N = normalized(normals[i % std::size(normals)]);
    const Basis about = basisAbout(N, {0, 1, 0});
    constexpr double turn = 2.0 * std::numbers::pi;
    const Vec3d L = normalized(directionIn(about, polarAngle(spreadOut(i, 0)), turn * spreadOut(i, 1)));
    if (i % 3 == 0)
        return {N, L, normalized(directionIn(about, polarAngle(spreadOut(i, 2)), turn * spreadOut(i, 3)))};
    const double away = std::pow(10.0, -4.0 * spreadOut(i, 2));
    const Basis near = basisAbout(normalized(i % 3 == 1 ? mirrored(N, L) : L), N);
    return {N, L, normalized(directionIn(near, away, turn * spreadOut(i, 3)))};
}

} // namespace

std::vector<Numbers> parameterSamples(const ModelText& model, std::size_t interior)
{
    const Numbers initial = defaults(model);
    std::vector<Numbers> samples{initial};
    // 64 corners at most: parameters after the sixth go along with it.
    const std::size_t bits = std::min<std::size_t>(model.parameters.size(), 6);
    for (std::size_t corner = 0; corner < (std::size_t{1} << bits) && bits > 0; ++corner) {
        samples.push_back(initial);
        for (std::size_t i = 0; i < model.parameters.size(); ++i) {
            const auto marks = landmarks(model.parameters[i]);
            const bool high = (corner >> std::min(i, bits - 1)) & 1U;
            put(model.parameters[i], high ? marks.back() : marks.front(), samples.back());
        }
    }
    // Alone at its landmarks, the others at their high ends: a matte surface gives too much where it is white and just
    // slightly rough.
    for (const Parameter& p : model.parameters)
        for (const Numbers& landmark : landmarks(p)) {
            samples.push_back(samples[std::size_t{1} << bits]);
            put(p, landmark, samples.back());
        }
    for (std::size_t i = 0; i < interior && !model.parameters.empty(); ++i) {
        samples.push_back(initial);
        for (const Parameter& p : model.parameters)
            put(p, interiorPoint(p, i), samples.back());
    }
    for (Numbers& flat : samples)
        flat = withListsInForm(model, std::move(flat));
    return samples;
}

std::vector<Numbers> legalEnds(const ModelText& model)
{
    std::vector<Numbers> samples;
    for (const Parameter& p : model.parameters)
        for (const double end : {p.legalMin, p.legalMax})
            if (std::isfinite(end) && (end < p.sliderMin || end > p.sliderMax)) {
                samples.push_back(defaults(model));
                put(p, Numbers(p.size, end), samples.back());
            }
    return samples;
}

std::vector<Directions> directionSamples(std::size_t count)
{
    std::vector<Directions> samples;
    for (std::size_t i = 0; samples.size() < count; ++i) {
        const Directions d = litSample(i);
        if (dot(d.N, d.L) >= smallestCosine && dot(d.N, d.V) >= smallestCosine)
            samples.push_back(d);
    }
    return samples;
}

std::vector<Directions> unlitSamples(std::size_t count)
{
    // On the horizon N.L must be 0 to the last bit, so N is an axis there.
    std::vector<Directions> samples{{{0, 0, 1}, {1, 0, 0}, {1, 0, 0}},
                                    {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}},
                                    {{0, 0, 1}, {0, -0.6, 0}, {0, 0.6, 0.8}},
                                    {{0, 0, 1}, {1, 0, -1e-15}, {-1, 0, 1e-15}}};
    for (std::size_t i = 0; i < count; ++i) {
        Directions d = litSample(i);
        d.L = -d.L;
        if (i % 4 == 0)
            d.V = -d.V;
        if (i % 4 == 1)
            d.V = normalized(mirrored(d.N, d.L));
        samples.push_back(d);
    }
    return samples;
}

} // namespace reflectance::properties
