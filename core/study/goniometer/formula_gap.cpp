#include "core/study/goniometer/formula_gap.h"

#include "core/math/angle.h"
#include "core/reflectance/evaluate.h"

#include <cmath>
#include <numbers>

namespace reflectance {

FactorFunction factorOf(const Model& model, std::vector<double> values)
{
    return [&model, values = std::move(values)](std::span<const DirectionPair> pairs) {
        std::vector<Observation> rows;
        for (const DirectionPair& pair : pairs)
            rows.push_back({{0, 0, 1}, pair.V, {{pair.L, Vec3d(1.0)}}});
        std::vector<double> factors;
        for (const Vec3d& seen : evaluate(model, values, rows, Precision::Double))
            factors.push_back((seen.x + seen.y + seen.z) / 3.0);
        return factors;
    };
}

FactorFunction onceReflected(const Model& model, const ParameterValues& values, double rho)
{
    const auto with = [&](double albedo) {
        ParameterValues changed = values;
        changed["rho"] = {albedo, albedo, albedo};
        return factorOf(model, flatValues(model.text, changed));
    };
    // 4 (rho a / 2 + rho^2 b / 4) - (rho a + rho^2 b) = rho a
    return [half = with(0.5 * rho), whole = with(rho)](std::span<const DirectionPair> pairs) {
        std::vector<double> once = half(pairs);
        const std::vector<double> all = whole(pairs);
        for (std::size_t i = 0; i < once.size(); ++i)
            once[i] = 4.0 * once[i] - all[i];
        return once;
    };
}

GreyCell greyOf(const LabRun& run, std::size_t index)
{
    const LabCell& cell = run.cells[index];
    const std::size_t channels = run.setup.channels;
    GreyCell grey;
    double squares = 0.0;
    for (std::size_t c = 0; c < channels; ++c) {
        grey.f += cell.mean[c];
        squares += std::pow(cell.standardError(c), 2);
    }
    // White light reaches each channel by one number, or by the three of a row.
    const double share = channels == 9 ? 1.0 / 3.0 : 1.0 / static_cast<double>(channels);
    // Channels share their paths: their errors go together, and add up at most as lengths do.
    return {share * grey.f, share * std::sqrt(squares * static_cast<double>(channels))};
}

FormulaGap gapBetween(const LabRun& run, const FactorFunction& formula)
{
    std::vector<DirectionPair> pairs;
    for (std::size_t cell = 0; cell < run.cells.size(); ++cell)
        pairs.push_back(directionsOf(run.setup, cell));
    const std::vector<double> factors = formula(pairs);
    const double steepest = std::cos(radians(75.001));
    FormulaGap gap;
    double squares = 0.0;
    double noise = 0.0;
    double whole = 0.0;
    double sum = 0.0;
    double light = 0.0;
    for (std::size_t cell = 0; cell < pairs.size(); ++cell) {
        const auto& [L, V] = pairs[cell];
        const GreyCell grey = greyOf(run, cell);
        if (run.cells[cell].batches < 2)
            continue;
        const double difference = factors[cell] / (std::numbers::pi * L.z) - grey.f;
        const double weight = L.z * V.z * std::hypot(L.x, L.y) * std::hypot(V.x, V.y);
        squares += weight * difference * difference;
        noise += weight * grey.error * grey.error;
        whole += weight * grey.f * grey.f;
        sum += weight * difference;
        light += weight * grey.f;
        const double seen = std::numbers::pi * L.z * std::fabs(difference);
        if (L.z >= steepest && V.z >= steepest && seen > gap.worst) {
            gap.worst = seen;
            gap.worstCell = cell;
        }
    }
    if (whole > 0.0) {
        gap.rms = std::sqrt(squares / whole);
        gap.noise = std::sqrt(noise / whole);
        gap.mean = sum / light;
    }
    return gap;
}

} // namespace reflectance
