#include "core/measured/interpolate.h"

#include <algorithm>

namespace reflectance {
namespace {

bool isWhole(const Share& share)
{
    return share.weight == 1.0;
}

/// Slope at the sample between two intervals of widths h0, h1 and slopes d0, d1: the weighted harmonic mean of Fritsch and
/// Butland 1984, which keeps the curve monotone between samples.
double slopeBetween(double h0, double d0, double h1, double d1)
{
    if (!(d0 * d1 > 0.0))
        return 0.0;
    const double w0 = h0 + 2.0 * h1;
    const double w1 = 2.0 * h0 + h1;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Slope at an end: no curvature there, and inside the region in which Fritsch and Carlson 1980 prove monotony.
double slopeAtEnd(double d, double other)
{
    const double natural = 0.5 * (3.0 * d - other);
    return natural * d <= 0.0 ? 0.0 : d > 0.0 ? std::min(natural, 3.0 * d) : std::max(natural, 3.0 * d);
}

double hermite(double a, double b, double slopeA, double slopeB, double h, double t)
{
    const double s = 1.0 - t;
    return a + (b - a) * t * t * (3.0 - 2.0 * t) + h * t * s * (s * slopeA - t * slopeB);
}

class Interpolator {
public:
    Interpolator(const Table& table, const Places& places) : table_(table), places_(places) {}

    /// `first` counts the samples of the axes already chosen.
    [[nodiscard]] Share along(std::size_t axis, std::size_t first) const
    {
        if (axis == table_.axes.size())
            return sample(first);
        const auto at = [&](std::size_t i) { return along(axis + 1, first * table_.axes[axis].size() + i); };
        const auto [below, t] = places_[axis];
        if (table_.interpolation == Interpolation::Nearest)
            return at(t < 0.5 ? below : below + 1);
        if (t == 0.0)
            return at(below);
        const Share a = at(below);
        const Share b = at(below + 1);
        if (table_.interpolation == Interpolation::MonotoneCubic && isWhole(a) && isWhole(b))
            return cubic(axis, at, a, b);
        return linear(a, b, t);
    }

private:
    [[nodiscard]] Share sample(std::size_t index) const
    {
        Share share;
        if (table_.isHole(index))
            return share;
        const double* const values = &table_.values[index * table_.channels];
        std::copy(values, values + table_.channels, share.values.begin());
        share.weight = 1.0;
        return share;
    }

    [[nodiscard]] Share linear(const Share& a, const Share& b, double t) const
    {
        const double fromB = t * b.weight;
        Share share;
        share.weight = isWhole(a) && isWhole(b) ? 1.0 : (1.0 - t) * a.weight + fromB;
        if (share.weight == 0.0)
            return share;
        for (std::size_t c = 0; c < table_.channels; ++c) // equal samples give themselves, to the bit
            share.values[c] = a.values[c] + (fromB / share.weight) * (b.values[c] - a.values[c]);
        return share;
    }

    template <class At> [[nodiscard]] Share cubic(std::size_t axis, const At& at, const Share& a, const Share& b) const
    {
        const auto& x = table_.axes[axis];
        const auto [i, t] = places_[axis];
        const Share before = i > 0 ? at(i - 1) : Share();
        const Share after = i + 2 < x.size() ? at(i + 2) : Share();
        const double h = x[i + 1] - x[i];
        Share share{{}, 1.0};
        for (std::size_t c = 0; c < table_.channels; ++c) {
            const double d = (b.values[c] - a.values[c]) / h;
            double slopeA = d;
            double slopeB = d;
            if (isWhole(before))
                slopeA = slopeBetween(x[i] - x[i - 1], (a.values[c] - before.values[c]) / (x[i] - x[i - 1]), h, d);
            if (isWhole(after))
                slopeB =
                    slopeBetween(h, d, x[i + 2] - x[i + 1], (after.values[c] - b.values[c]) / (x[i + 2] - x[i + 1]));
            if (!isWhole(before))
                slopeA = slopeAtEnd(d, slopeB);
            if (!isWhole(after))
                slopeB = slopeAtEnd(d, slopeA);
            share.values[c] = hermite(a.values[c], b.values[c], slopeA, slopeB, h, t);
        }
        return share;
    }

    const Table& table_;
    const Places& places_;
};

} // namespace

Place placeIn(const std::vector<double>& samples, double angle)
{
    const auto above = std::upper_bound(samples.begin(), samples.end(), angle);
    if (above == samples.begin())
        return {};
    const auto below = static_cast<std::size_t>(above - samples.begin()) - 1;
    if (above == samples.end())
        return {below, 0.0};
    return {below, (angle - samples[below]) / (samples[below + 1] - samples[below])};
}

Share interpolated(const Table& table, const Places& places)
{
    return Interpolator(table, places).along(0, 0);
}

} // namespace reflectance
