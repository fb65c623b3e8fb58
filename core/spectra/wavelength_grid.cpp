#include "core/spectra/wavelength_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace reflectance {
namespace {

void addPiece(WavelengthGrid& grid, double from, double to)
{
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    const double off = std::sqrt(0.6) * half;
    const double nodes[] = {middle - off, middle, middle + off};
    const double weights[] = {5.0 / 9.0 * half, 8.0 / 9.0 * half, 5.0 / 9.0 * half};
    grid.nm.insert(grid.nm.end(), std::begin(nodes), std::end(nodes));
    grid.weight.insert(grid.weight.end(), std::begin(weights), std::end(weights));
}

} // namespace

WavelengthGrid gridThrough(std::vector<double> knots, const WavelengthRange& range, int cuts)
{
    std::erase_if(knots, [&range](double nm) { return !(nm > range.from && nm < range.to); });
    knots.insert(knots.end(), {range.from, range.to});
    std::sort(knots.begin(), knots.end());
    WavelengthGrid grid;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double step = (knots[i] - knots[i - 1]) / cuts;
        if (!(step > 0.0))
            continue;
        for (int cut = 0; cut < cuts; ++cut)
            addPiece(grid, knots[i - 1] + cut * step, knots[i - 1] + (cut + 1) * step);
    }
    return grid;
}

std::vector<double> sampledOn(const WavelengthGrid& grid, const Spectrum& spectrum)
{
    std::vector<double> values(grid.size());
    std::transform(grid.nm.begin(), grid.nm.end(), values.begin(), [&](double nm) { return spectrum.at(nm); });
    return values;
}

} // namespace reflectance
