#include "core/study/lens/suspects.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/math/lobe.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

constexpr double eps = 0x1p-24;

/// One light at one sample.
struct Lit {
    const Model& model;
    const std::vector<double>& values;
    Vec3d N, L, V, I;
    double radius;
    double share = 1.0; ///< of the value's size, that this light makes
};

double sizeOf(const Vec3d& v)
{
    return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

Vec3d valueOf(const Lit& lit, const std::vector<double>& values)
{
    const Observation row{lit.N, lit.V, {{lit.L, lit.I, lit.radius}}};
    return evaluate(lit.model, values, {&row, 1}, Precision::Double).front();
}

/// The share of the value that goes when a parameter is 0.
double shareWithout(const Lit& lit, const Parameter& parameter)
{
    std::vector<double> without = lit.values;
    const auto first = without.begin() + static_cast<std::ptrdiff_t>(parameter.offset);
    std::fill_n(first, parameter.size, 0.0);
    const Vec3d value = valueOf(lit, lit.values);
    return sizeOf(value) > 0.0 ? std::min(1.0, sizeOf(value - valueOf(lit, without)) / sizeOf(value)) : 0.0;
}

void suspectHorizon(const Lit& lit, std::vector<Suspect>& suspects)
{
    const Vec3d& N = lit.N;
    const Vec3d& L = lit.L;
    const double cosine = dot(N, L);
    const std::string value = "N.L = " + general(static_cast<double>(dot(Vec3f(N), Vec3f(L))), 3);
    if (std::fabs(cosine) < 4.0 * eps)
        suspects.push_back({std::numeric_limits<double>::infinity(), value + ": within 4 eps of the horizon"});
    else if (cosine > 0.0)
        suspects.push_back({lit.share * (std::fabs(N.x * L.x) + std::fabs(N.y * L.y) + std::fabs(N.z * L.z)) / cosine,
                            value + ": near the horizon"});
}

void suspectLobe(const Lit& lit, std::vector<Suspect>& suspects)
{
    const Parameter* n = lit.model.text.find("n");
    if (!n || lit.model.text.code.find("lobe(mirrored(N, L), V, n)") == std::string::npos)
        return;
    const Vec3d R = mirrored(lit.N, lit.L);
    const Vec3d chord = R - lit.V;
    const double x = 0.5 * dot(chord, chord); // 1 - R.V
    if (!(x < 1.0) || !(dot(lit.N, lit.L) > 0.0))
        return;
    const double exponent = lit.values[n->offset];
    const double tangent = std::sqrt(x * (2.0 - x)) / (1.0 - x);
    const Parameter* ks = lit.model.text.find("ks");
    const double share = lit.share * (ks ? shareWithout(lit, *ks) : 1.0);
    const float got = dot(mirrored(Vec3f(lit.N), Vec3f(lit.L)), Vec3f(lit.V));
    suspects.push_back(
        {share * exponent * (tangent - std::log1p(-x)),
         "R.V = " + general(static_cast<double>(got), 8) + ", n = " + general(exponent, 4) + ": the lobe"});
}

void suspectMatrix(const Lit& lit, std::vector<Suspect>& suspects)
{
    for (const Parameter& matrix : lit.model.text.parameters) {
        if (matrix.kind != ParameterKind::Matrix)
            continue;
        const double share = lit.share * shareWithout(lit, matrix);
        for (std::size_t row = 0; row < 3; ++row) {
            const double* K = &lit.values[matrix.offset + 3 * row];
            const Vec3d parts{K[0] * lit.I.x, K[1] * lit.I.y, K[2] * lit.I.z};
            const double sum = std::fabs(parts.x + parts.y + parts.z);
            if (sizeOf(parts) > 2.0 * sum)
                suspects.push_back({sum > 0.0 ? share * sizeOf(parts) / sum : std::numeric_limits<double>::infinity(),
                                    "cancellation in " + matrix.name + " I, row " + std::to_string(row + 1) + ": " +
                                        general(sizeOf(parts), 3) + " leaves " + general(sum, 3)});
        }
    }
}

void suspectRim(const Lit& lit, std::vector<Suspect>& suspects)
{
    if (!lit.model.text.usesLightSize || !(lit.radius > 0.0))
        return;
    const Vec3d chord = mirrored(lit.N, lit.L) - lit.V;
    const double reach = squaredChord(lit.radius);
    const double apart = std::fabs(dot(chord, chord) - reach);
    if (apart < 64.0 * eps * std::sqrt(reach))
        suspects.push_back({reach / std::max(apart, 1e-300), "V lies on the rim of the light's disc about R"});
}

} // namespace

std::vector<Suspect> suspectsAt(const ViewSamples& samples, std::size_t sample, const Scene& scene)
{
    const Model& model = modelOf(scene);
    const std::vector<double> values = valuesOf(scene);
    const Vec3d P{samples.Px[sample], samples.Py[sample], samples.Pz[sample]};
    std::vector<Lit> lights;
    double total = 0.0;
    for (const Light& light : shiningLights(scene)) {
        const Arrival arrival = arrivalAt(light, P);
        Lit lit{model,
                values,
                {samples.Nx[sample], samples.Ny[sample], samples.Nz[sample]},
                arrival.L,
                normalized(samples.eye - P),
                arrival.I,
                light.angularRadius};
        lit.share = sizeOf(valueOf(lit, values));
        total += lit.share;
        lights.push_back(lit);
    }
    std::vector<Suspect> suspects;
    for (Lit& lit : lights) {
        lit.share = total > 0.0 ? lit.share / total : 1.0;
        suspectHorizon(lit, suspects);
        suspectLobe(lit, suspects);
        suspectMatrix(lit, suspects);
        suspectRim(lit, suspects);
    }
    return suspects;
}

} // namespace reflectance
