#include "core/study/exports/test_vectors.h"

#include "core/math/angle.h"
#include "core/math/lobe.h"
#include "core/reflectance/shade_block.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr double step = 16.0 * 0x1p-24;
constexpr double discRadius = 5.0; ///< degrees, where the model sees a light's extent

struct Tangents {
    Vec3d N, T, B;

    [[nodiscard]] Vec3d at(double theta, double phi) const
    {
        return normalized(std::sin(theta) * (std::cos(phi) * T + std::sin(phi) * B) + std::cos(theta) * N);
    }
};

Tangents about(const Vec3d& N)
{
    const Vec3d T = normalized(cross(std::fabs(N.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0), N));
    return {N, T, cross(N, T)};
}

/// All of them with these values, as they stand: not normalised again.
std::vector<Vec3d> shaded(const Model& model, std::span<const double> values, const MeasuredSurfaces& measured,
                          const std::vector<TestVector>& vectors)
{
    std::vector<Vec3d> results;
    results.reserve(vectors.size());
    ShadeBlock<double> block;
    for (std::size_t begin = 0; begin < vectors.size(); begin += blockSize) {
        const std::size_t count = std::min(blockSize, vectors.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const TestVector& v = vectors[begin + i];
            block.N.set(i, v.N);
            block.L.set(i, v.L);
            block.V.set(i, v.V);
            block.I.set(i, v.I);
            block.lightDisc[i] = squaredChord(v.lightRadius);
        }
        block.sum.fill({});
        ShadeBatch<double> batch = block.batch(count);
        batch.measured = measured.exact;
        model.exact.shade(values.data(), batch);
        for (std::size_t i = 0; i < count; ++i)
            results.push_back(block.sum[i]);
    }
    return results;
}

Vec3d larger(const Vec3d& a, const Vec3d& b)
{
    return {std::fmax(std::fabs(a.x), std::fabs(b.x)), std::fmax(std::fabs(a.y), std::fabs(b.y)),
            std::fmax(std::fabs(a.z), std::fabs(b.z))};
}

/// Adds the change between two sets of results to each vector's sensitivity.
void addChange(const std::vector<Vec3d>& up, const std::vector<Vec3d>& down, std::vector<TestVector>& vectors)
{
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        TestVector& v = vectors[i];
        v.sensitivity += larger(up[i] - v.expected, down[i] - v.expected) / step;
    }
}

void fillIn(const Model& model, std::span<const double> values, const MeasuredSurfaces& measured,
            std::vector<TestVector>& vectors)
{
    const std::vector<Vec3d> truth = shaded(model, values, measured, vectors);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        vectors[i].expected = truth[i];
    for (Vec3d TestVector::*direction : {&TestVector::N, &TestVector::L, &TestVector::V})
        for (double Vec3d::*component : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
            const auto moved = [&](double way) {
                std::vector<TestVector> others = vectors;
                for (TestVector& other : others)
                    other.*direction.*component += way * step;
                return shaded(model, values, measured, others);
            };
            addChange(moved(1.0), moved(-1.0), vectors);
        }
    for (const Parameter& parameter : model.text.parameters)
        for (std::size_t i = parameter.offset; i < parameter.offset + parameter.size; ++i) {
            if (parameter.kind == ParameterKind::Choice || values[i] == 0.0) // exact in every arithmetic
                continue;
            const auto moved = [&](double way) {
                std::vector<double> others(values.begin(), values.end());
                others[i] *= 1.0 + way * step;
                return shaded(model, others, measured, vectors);
            };
            addChange(moved(1.0), moved(-1.0), vectors);
        }
}

void addViewers(const Tangents& frame, double thetaI, double phiI, TestVector vector, std::vector<TestVector>& vectors)
{
    vector.N = frame.N;
    vector.L = frame.at(thetaI, phiI);
    const auto seenFrom = [&](const Vec3d& V) {
        vector.V = V;
        vectors.push_back(vector);
    };
    const double across = phiI + std::numbers::pi;
    seenFrom(normalized(mirrored(vector.N, vector.L)));
    for (const double off : {1e-3, 0.02, 0.15, 0.5})
        seenFrom(frame.at(std::fabs(thetaI - off), thetaI < off ? phiI : across));
    seenFrom(frame.at(thetaI, across + 0.05));
    seenFrom(frame.at(thetaI, phiI + 0.1));
    seenFrom(frame.at(0.6, phiI + 1.0));
    seenFrom(frame.at(1.35, phiI + 2.2));
}

} // namespace

Vec3d toleranceOf(const TestVector& vector, double roundoff)
{
    const double floor = roundoff < 0x1p-40 ? 0x1p-960 : 0x1p-90;
    const auto of = [&](double expected, double sensitivity, double light) {
        return 64.0 * (sensitivity + std::fabs(expected)) * 2.0 * roundoff + floor * light;
    };
    const double light = std::max({vector.I.x, vector.I.y, vector.I.z});
    return {of(vector.expected.x, vector.sensitivity.x, light), of(vector.expected.y, vector.sensitivity.y, light),
            of(vector.expected.z, vector.sensitivity.z, light)};
}

std::vector<TestVector> testVectors(const Model& model, std::span<const double> values,
                                    const MeasuredSurfaces& measured)
{
    std::vector<TestVector> vectors;
    TestVector vector;
    vector.lightRadius = model.text.usesLightSize ? discRadius : 0.0;
    const Tangents up = about({0, 0, 1});
    const Tangents tilted = about(normalized(Vec3d{0.36, -0.48, 0.8}));
    vector.I = {1.0, 1.0, 1.0};
    for (const double thetaI : {0.0, 0.7, 1.48}) // the last 5 degrees above the horizon
        addViewers(up, thetaI, 0.4, vector, vectors);
    vector.I = {1.0, 0.75, 2.5};
    for (const double thetaI : {0.3, 1.1})
        addViewers(tilted, thetaI, 2.0, vector, vectors);
    vector.N = up.N;
    for (const auto& [L, V] :
         {std::pair(up.at(2.0, 0.0), up.at(0.5, 1.0)), std::pair(up.at(0.5, 1.0), up.at(2.0, 0.0))}) {
        vector.L = L;
        vector.V = V;
        vectors.push_back(vector);
    }
    fillIn(model, values, measured, vectors);
    return vectors;
}

std::vector<TestVector> gridVectors(const Model& model, std::span<const double> values,
                                    const MeasuredSurfaces& measured)
{
    const Tangents up = about({0, 0, 1});
    std::vector<double> polar;
    for (int degree = 0; degree < 90; degree += 10)
        polar.push_back(radians(degree));
    polar.push_back(radians(85));
    std::vector<TestVector> vectors;
    TestVector vector;
    vector.N = up.N;
    vector.I = {1.0, 1.0, 1.0};
    vector.lightRadius = model.text.usesLightSize ? discRadius : 0.0;
    for (const double thetaI : polar)
        for (const double thetaR : polar)
            for (const double phi : {0.0, 45.0, 90.0, 135.0, 180.0}) {
                vector.L = up.at(thetaI, 0.0);
                vector.V = up.at(thetaR, radians(phi));
                vectors.push_back(vector);
            }
    fillIn(model, values, measured, vectors);
    return vectors;
}

} // namespace reflectance
