#include "core/study/fit/observations.h"

#include "core/math/angle.h"
#include "core/math/lobe.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3d up{0.0, 0.0, 1.0};

void take(Observations& observations, const Vec3d& L, const Vec3d& V, const Vec3d& I, const Vec3d& reflected)
{
    observations.rows.push_back({up, V, {{L, I}}});
    observations.seen.push_back(reflected * (pi * L.z));
    observations.cosine.push_back(L.z);
}

ObservedForm formOf(std::size_t channels)
{
    return channels == 1 ? ObservedForm::Grey : channels == 3 ? ObservedForm::Color : ObservedForm::Matrix;
}

Angles anglesAt(const Table& table, std::size_t sample)
{
    Angles at{};
    for (std::size_t axis = table.axes.size(); axis-- > 0;) {
        at[axis] = table.axes[axis][sample % table.axes[axis].size()];
        sample /= table.axes[axis].size();
    }
    return at;
}

/// Odd, so that a stride does not run along one value of an even axis.
std::size_t strideFor(std::size_t samples, std::size_t most)
{
    const std::size_t stride = samples / most + (samples % most != 0 ? 1 : 0);
    return std::max<std::size_t>(1, stride | 1U);
}

} // namespace

void observe(Observations& observations, const Vec3d& L, const Vec3d& V, const Mat3d& f)
{
    if (observations.form != ObservedForm::Matrix)
        return take(observations, L, V, Vec3d(1.0), f * Vec3d(1.0));
    for (const Vec3d& primary : {Vec3d{1.0, 0.0, 0.0}, Vec3d{0.0, 1.0, 0.0}, Vec3d{0.0, 0.0, 1.0}})
        take(observations, L, V, primary, f * primary);
}

Observations observationsOf(const Table& table, std::size_t most)
{
    Observations observations{table.provenance.name, formOf(table.channels), {}, {}, {}};
    const std::size_t stride = table.samples() > most ? strideFor(table.samples(), most) : 1;
    for (std::size_t sample = 0; sample < table.samples(); sample += stride) {
        const auto [L, V] = directionsAt(table.system, anglesAt(table, sample));
        if (table.isHole(sample) || !(L.z > 0.0) || !(V.z > 0.0))
            continue;
        Channels values{};
        std::copy_n(&table.values[sample * table.channels], table.channels, values.begin());
        observe(observations, L, V, matrixOf(values, table.channels));
    }
    return observations;
}

Observations greyOf(const Observations& observations)
{
    Observations grey{observations.name, ObservedForm::Grey, {}, {}, {}};
    const double rowsOfOne = observations.form == ObservedForm::Matrix ? 3.0 : 1.0;
    for (std::size_t i = 0; i < observations.rows.size(); ++i) {
        const Vec3d& seen = observations.seen[i];
        const double mean = observations.channels() == 1 ? seen.x : (seen.x + seen.y + seen.z) / 3.0;
        if (i % static_cast<std::size_t>(rowsOfOne) != 0) { // the next primary at the same directions
            grey.seen.back().x += mean;
            continue;
        }
        Observation row = observations.rows[i];
        for (ObservedLight& light : row.lights)
            light.I = Vec3d(1.0);
        grey.rows.push_back(std::move(row));
        grey.seen.emplace_back(mean, 0.0, 0.0);
        grey.cosine.push_back(observations.cosine[i]);
    }
    return grey;
}

double nearestMirror(const Observations& observations)
{
    double nearest = pi;
    for (const Observation& row : observations.rows)
        for (const ObservedLight& light : row.lights) {
            const Vec3d R = mirrored(normalized(row.N), normalized(light.L));
            const Vec3d chord = R - normalized(row.V);
            nearest = std::min(nearest, 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(dot(chord, chord)))));
        }
    return nearest;
}

} // namespace reflectance
