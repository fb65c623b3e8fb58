#include "core/spectra/color_system.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

constexpr std::size_t mostNodes = 400'000;
constexpr int mostHalvings = 8;

template <class Spectra> WavelengthRange rangeOfAll(const Spectra& spectra)
{
    WavelengthRange all;
    for (const Spectrum& spectrum : spectra)
        all = hullOf(all, spectrum.range());
    return all;
}

std::string text(const WavelengthRange& range)
{
    return general(range.from, 6) + " .. " + general(range.to, 6) + " nm";
}

/// Where both light and sensor are.
Result<WavelengthRange> commonRange(const SpectrumTriple& primaries, const SpectrumTriple& sensors,
                                    const AlsoOnGrid& also)
{
    const WavelengthRange ofLights = hullOf(rangeOfAll(primaries), rangeOfAll(also.lights));
    const WavelengthRange ofSensors = rangeOfAll(sensors);
    const WavelengthRange common = overlapOf(ofLights, ofSensors);
    if (common.empty())
        return Error{"the light (" + text(ofLights) + ") and the sensor (" + text(ofSensors) +
                     ") have no wavelength in common; is one of them in another unit?"};
    for (const Spectrum& reflectance : also.reflectances)
        if (overlapOf(reflectance.range(), common).empty())
            return Error{"reflectance '" + reflectance.name + "' (" + text(reflectance.range()) +
                         ") has no wavelength in common with light and sensor (" + text(common) +
                         "); is it in another unit?"};
    return common;
}

std::vector<double> knotsOfAll(const SpectrumTriple& primaries, const SpectrumTriple& sensors, const AlsoOnGrid& also)
{
    std::vector<double> knots;
    const auto add = [&knots](const auto& spectra) {
        for (const Spectrum& spectrum : spectra) {
            const auto own = spectrum.knots();
            knots.insert(knots.end(), own.begin(), own.end());
        }
    };
    add(primaries);
    add(sensors);
    add(also.reflectances);
    add(also.lights);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

void sample(ColorSystem& system, const SpectrumTriple& primaries, const SpectrumTriple& sensors)
{
    for (std::size_t c = 0; c < 3; ++c) {
        system.primaries[c] = sampledOn(system.grid, primaries[c]);
        system.sensors[c] = sampledOn(system.grid, sensors[c]);
        for (std::size_t k = 0; k < system.grid.size(); ++k)
            system.sensors[c][k] *= system.grid.weight[k];
    }
}

/// Every integral that anyone will ask for: M of all reflectances and of white, and each light on white and on them.
std::vector<Mat3d> integralsOf(const ColorSystem& system, const AlsoOnGrid& also)
{
    std::vector<Mat3d> integrals{system.M({})};
    for (const Spectrum& reflectance : also.reflectances)
        integrals.push_back(system.M(sampledOn(system.grid, reflectance)));
    for (const Spectrum& light : also.lights)
        integrals.push_back(diagonalMatrix(system.response(sampledOn(system.grid, light), {})));
    return integrals;
}

double largestChange(const std::vector<Mat3d>& before, const std::vector<Mat3d>& after)
{
    double largest = 0.0;
    for (std::size_t m = 0; m < after.size(); ++m) {
        const auto old = rowByRow(before[m]);
        const auto now = rowByRow(after[m]);
        double size = 0.0;
        double change = 0.0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            size = std::max(size, std::fabs(now[i]));
            change = std::max(change, std::fabs(now[i] - old[i]));
        }
        largest = std::max(largest, size > 0.0 ? change / size : 0.0);
    }
    return largest;
}

/// Cuts every piece in two until nothing changes any more.
void refine(ColorSystem& system, const WavelengthRange& range, const SpectrumTriple& primaries,
            const SpectrumTriple& sensors, const AlsoOnGrid& also)
{
    const std::vector<double> knots = knotsOfAll(primaries, sensors, also);
    std::vector<Mat3d> before;
    for (int halving = 0; halving <= mostHalvings; ++halving) {
        system.grid = gridThrough(knots, range, 1 << halving);
        sample(system, primaries, sensors);
        std::vector<Mat3d> now = integralsOf(system, also);
        system.lastChange = before.empty() ? 1.0 : largestChange(before, now);
        if (system.lastChange <= also.standsStill || 2 * system.grid.size() > mostNodes)
            return;
        before = std::move(now);
    }
}

Result<void> checkSensors(const ColorSystem& system, const SpectrumTriple& sensors)
{
    constexpr const char* channels[] = {"red", "green", "blue"};
    for (std::size_t c = 0; c < 3; ++c) {
        const Vec3d row = system.W.rows[c];
        if (row.x == 0.0 && row.y == 0.0 && row.z == 0.0)
            return Error{std::string("the ") + channels[c] + " filter '" + sensors[c].name +
                         "' sees nothing of any primary; K needs a sensor that responds in every channel"};
    }
    if (!(conditionNumber(system.W) < largestCondition))
        return Error{"W is singular: the sensor cannot tell these primaries apart, so no K exists; choose primaries or "
                     "filters that differ"};
    return {};
}

} // namespace

Vec3d ColorSystem::response(const std::vector<double>& light, const std::vector<double>& S) const
{
    Vec3d sum;
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const double leaving = S.empty() ? light[k] : light[k] * S[k];
        sum += leaving * Vec3d(sensors[0][k], sensors[1][k], sensors[2][k]);
    }
    return sum;
}

Mat3d ColorSystem::M(const std::vector<double>& S) const
{
    return transposed({{response(primaries[0], S), response(primaries[1], S), response(primaries[2], S)}});
}

Mat3d ColorSystem::K(const std::vector<double>& S, Convention convention) const
{
    return convention == Convention::Primary ? M(S) : M(S) * inverse(W);
}

Result<ColorSystem> makeColorSystem(const SpectrumTriple& primaries, const SpectrumTriple& sensors,
                                    const AlsoOnGrid& also)
{
    const auto range = commonRange(primaries, sensors, also);
    if (!range)
        return range.error();
    ColorSystem system;
    refine(system, *range, primaries, sensors, also);
    system.W = system.M({});
    if (const auto good = checkSensors(system, sensors); !good)
        return good.error();
    system.gain = inverse(system.W) * Vec3d(1.0);
    system.makesWhite = system.gain.x > 0.0 && system.gain.y > 0.0 && system.gain.z > 0.0;
    const double gains[] = {system.gain.x, system.gain.y, system.gain.z};
    for (std::size_t c = 0; system.makesWhite && c < 3; ++c)
        for (double& power : system.primaries[c])
            power *= gains[c];
    system.W = system.M({});
    system.condition = conditionNumber(system.W);
    return system;
}

Result<SpectrumTriple> balanced(SpectrumTriple sensors, const Spectrum& light)
{
    const WavelengthRange range = overlapOf(light.range(), rangeOfAll(sensors));
    for (Spectrum& sensor : sensors) {
        double seen = 0.0;
        if (!range.empty()) {
            std::vector<double> knots = light.knots();
            const auto own = sensor.knots();
            knots.insert(knots.end(), own.begin(), own.end());
            const WavelengthGrid grid = gridThrough(std::move(knots), range, 4);
            for (std::size_t k = 0; k < grid.size(); ++k)
                seen += grid.weight[k] * light.at(grid.nm[k]) * sensor.at(grid.nm[k]);
        }
        if (!(seen > 0.0))
            return Error{"the filter '" + sensor.name + "' sees nothing of the light '" + light.name +
                         "', so it cannot be balanced to it"};
        sensor = scaled(std::move(sensor), 1.0 / seen);
    }
    return sensors;
}

} // namespace reflectance
