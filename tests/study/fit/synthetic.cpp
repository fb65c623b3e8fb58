#include "tests/study/fit/synthetic.h"

#include "core/math/lobe.h"
#include "core/reflectance/evaluate.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

namespace reflectance {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::vector<double> steps(double first, double last, double step)
{
    std::vector<double> angles;
    for (double angle = first; angle <= last; angle += step)
        angles.push_back(angle * degree);
    return angles;
}

/// The whole matrix, by one light primary after the other.
Mat3d brdfOf(const Model& model, const std::vector<double>& flat, const DirectionPair& at)
{
    const Vec3d up{0.0, 0.0, 1.0};
    const std::vector<Observation> rows{{up, at.V, {{at.L, {1.0, 0.0, 0.0}}}},
                                        {up, at.V, {{at.L, {0.0, 1.0, 0.0}}}},
                                        {up, at.V, {{at.L, {0.0, 0.0, 1.0}}}}};
    const std::vector<Vec3d> columns = evaluate(model, flat, rows, Precision::Double);
    const double scale = 1.0 / (std::numbers::pi * at.L.z);
    return {{{columns[0].x * scale, columns[1].x * scale, columns[2].x * scale},
             {columns[0].y * scale, columns[1].y * scale, columns[2].y * scale},
             {columns[0].z * scale, columns[1].z * scale, columns[2].z * scale}}};
}

} // namespace

Table synthetic(const SyntheticTable& wanted)
{
    const Model& model = **findModel(wanted.model);
    const std::vector<double> flat = flatValues(model.text, wanted.values);
    Table table;
    table.system = AngleSystem::Isotropic;
    table.axes = {steps(10.0, 70.0, 10.0), steps(0.0, 70.0, 10.0), steps(0.0, 180.0, 30.0)};
    table.channels = wanted.channels;
    table.provenance.name = "synthetic";
    std::mt19937_64 random(wanted.seed);
    std::normal_distribution<double> noise(0.0, wanted.noise / std::numbers::pi);
    for (const double thetaI : table.axes[0])
        for (const double thetaR : table.axes[1])
            for (const double phi : table.axes[2]) {
                const DirectionPair at = directionsAt(table.system, {thetaI, thetaR, phi});
                const Mat3d f = brdfOf(model, flat, at);
                const bool isHole = wanted.isSeen && !wanted.isSeen(at.L, at.V);
                for (std::size_t c = 0; c < wanted.channels; ++c) {
                    const std::size_t entry = wanted.channels == 9 ? c : 4 * c;
                    const Vec3d& row = f.rows[entry / 3];
                    const double value = entry % 3 == 0 ? row.x : entry % 3 == 1 ? row.y : row.z;
                    table.values.push_back(isHole ? std::numeric_limits<double>::quiet_NaN()
                                                  : value + (wanted.noise > 0.0 ? noise(random) : 0.0));
                }
            }
    return table;
}

double degreesOffMirror(const Vec3d& L, const Vec3d& V)
{
    return std::acos(std::clamp(dot(mirrored(Vec3d{0.0, 0.0, 1.0}, L), V), -1.0, 1.0)) / degree;
}

} // namespace reflectance
