#include "core/study/tables/sample_model.h"

#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

/// Rows of f for each pair and each light colour, pair by pair.
std::vector<Vec3d> brdfs(const Model& model, const std::vector<double>& values, std::span<const DirectionPair> pairs,
                         std::span<const Vec3d> colours)
{
    std::vector<Observation> rows;
    rows.reserve(pairs.size() * colours.size());
    for (const DirectionPair& pair : pairs)
        for (const Vec3d& I : colours)
            rows.push_back({{0, 0, 1}, pair.V, {{pair.L, I}}});
    std::vector<Vec3d> result = evaluate(model, values, rows, Precision::Double);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = result[i] / (std::numbers::pi * pairs[i / colours.size()].L.z);
    return result;
}

constexpr Vec3d white[] = {{1, 1, 1}};
constexpr Vec3d primaries[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

} // namespace

std::size_t channelsOf(const Model& model, std::span<const double> values)
{
    std::vector<DirectionPair> pairs;
    for (int i = 0; i < 8; ++i)
        for (int r = 0; r < 8; ++r)
            for (int phi = 0; phi < 4; ++phi)
                pairs.push_back({directionAt(0.19 * i, 0.0), directionAt(0.19 * r, std::numbers::pi / 3.0 * phi)});
    const std::vector<Vec3d> rows = brdfs(model, {values.begin(), values.end()}, pairs, primaries);
    std::size_t channels = 1;
    for (std::size_t i = 0; i < rows.size(); i += 3) {
        const Vec3d& r = rows[i]; // what red light becomes: the first column
        const Vec3d& g = rows[i + 1];
        const Vec3d& b = rows[i + 2];
        if (r.y != 0.0 || r.z != 0.0 || g.x != 0.0 || g.z != 0.0 || b.x != 0.0 || b.y != 0.0)
            return 9;
        if (r.x != g.y || r.x != b.z)
            channels = 3;
    }
    return channels;
}

BrdfFunction brdfOf(const Model& model, std::vector<double> values, std::size_t channels)
{
    return [&model, values = std::move(values), channels](std::span<const DirectionPair> pairs) {
        std::vector<std::optional<Mat3d>> result;
        result.reserve(pairs.size());
        if (channels < 9)
            for (const Vec3d& f : brdfs(model, values, pairs, white))
                result.emplace_back(Mat3d{{{f.x, 0, 0}, {0, f.y, 0}, {0, 0, f.z}}});
        else {
            const auto rows = brdfs(model, values, pairs, primaries);
            for (std::size_t i = 0; i < rows.size(); i += 3) {
                const Vec3d &r = rows[i], &g = rows[i + 1], &b = rows[i + 2];
                result.emplace_back(Mat3d{{{r.x, g.x, b.x}, {r.y, g.y, b.y}, {r.z, g.z, b.z}}});
            }
        }
        return result;
    };
}

SampledModel sampledModel(const Model& model, const std::vector<double>& values, const GridShape& shape,
                          Interpolation interpolation, std::size_t mostChannels)
{
    const std::size_t own = channelsOf(model, values);
    const std::size_t channels = std::min(own, mostChannels);
    const BrdfFunction f = brdfOf(model, values, channels);
    SampledModel result;
    result.isUnderWhite = own > channels;
    result.table = sampled(shape, channels, f);
    result.table.interpolation = interpolation;
    result.table.provenance.name = model.id();
    result.table.provenance.format = "sampled model";
    result.table.provenance.convention = "BRDF in 1/sr";
    result.error = resamplingError(f, result.table);
    return result;
}

} // namespace reflectance
