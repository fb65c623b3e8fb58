#include "core/spectra/spectrum.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr double reach = 8.0; ///< deviations

WavelengthRange rangeOf(const GaussianBand& band)
{
    return {band.center - reach * band.deviation, band.center + reach * band.deviation};
}

double valueOf(const GaussianBand& band, double nm)
{
    const double x = (nm - band.center) / band.deviation;
    return std::fabs(x) < reach ? band.height * std::exp(-0.5 * x * x) : 0.0;
}

double tableAt(const Spectrum& table, double nm)
{
    const auto after = std::upper_bound(table.nm.begin(), table.nm.end(), nm);
    if (after == table.nm.begin() || (after == table.nm.end() && nm > table.nm.back())) {
        if (table.outside == Outside::Zero)
            return 0.0;
        return after == table.nm.begin() ? table.values.front() : table.values.back();
    }
    const auto i = static_cast<std::size_t>(std::min(after, table.nm.end() - 1) - table.nm.begin());
    const double share = (nm - table.nm[i - 1]) / (table.nm[i] - table.nm[i - 1]);
    return std::lerp(table.values[i - 1], table.values[i], share); // exact at both ends
}

} // namespace

WavelengthRange overlapOf(const WavelengthRange& a, const WavelengthRange& b)
{
    return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

WavelengthRange hullOf(const WavelengthRange& a, const WavelengthRange& b)
{
    if (a.empty() || b.empty())
        return a.empty() ? b : a;
    return {std::min(a.from, b.from), std::max(a.to, b.to)};
}

double Spectrum::at(double wavelength) const
{
    double sum = nm.empty() ? 0.0 : tableAt(*this, wavelength);
    for (const GaussianBand& band : bands)
        sum += valueOf(band, wavelength);
    return sum;
}

WavelengthRange Spectrum::range() const
{
    WavelengthRange all;
    if (!nm.empty())
        all = {nm.front(), nm.back()};
    for (const GaussianBand& band : bands)
        all = hullOf(all, rangeOf(band));
    return all;
}

std::vector<double> Spectrum::knots() const
{
    std::vector<double> all = nm;
    for (const GaussianBand& band : bands)
        for (int i = -static_cast<int>(reach); i <= static_cast<int>(reach); ++i)
            all.push_back(band.center + i * band.deviation);
    return all;
}

Spectrum scaled(Spectrum spectrum, double factor)
{
    for (double& value : spectrum.values)
        value *= factor;
    for (GaussianBand& band : spectrum.bands)
        band.height *= factor;
    return spectrum;
}

SpectrumTriple dividedIntoBands(const Spectrum& light, double blueToGreen, double greenToRed)
{
    constexpr double half = 0.5;
    std::vector<double> nm = light.nm;
    if (!light.bands.empty()) // tabulated, finely: the share of a band has no closed form
        for (double at = std::ceil(light.range().from); at <= light.range().to; at += half)
            nm.push_back(at);
    for (const double edge : {blueToGreen, greenToRed})
        nm.insert(nm.end(), {edge - half, edge + half});
    // Beyond the light its bands would only carry its last value on.
    std::erase_if(nm, [range = light.range()](double at) { return at < range.from || at > range.to; });
    std::sort(nm.begin(), nm.end());
    nm.erase(std::unique(nm.begin(), nm.end()), nm.end());
    const auto shareAbove = [](double at, double edge) { return std::clamp(at - edge + half, 0.0, 1.0); };

    SpectrumTriple parts;
    constexpr const char* names[] = {" red", " green", " blue"};
    for (std::size_t c = 0; c < 3; ++c)
        parts[c].name = light.name + names[c];
    for (const double at : nm) {
        const double red = shareAbove(at, greenToRed);
        const double notBlue = shareAbove(at, blueToGreen);
        const double shares[] = {red, notBlue - red, 1.0 - notBlue};
        for (std::size_t c = 0; c < 3; ++c) {
            parts[c].nm.push_back(at);
            parts[c].values.push_back(light.at(at) * shares[c]);
        }
    }
    return parts;
}

} // namespace reflectance
