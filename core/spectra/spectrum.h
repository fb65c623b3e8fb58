// A quantity over wavelength: reflectance, the power of a light, the sensitivity of a sensor.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace reflectance {

/// height * exp(-((nm - center) / deviation)^2 / 2), cut off 8 deviations from its centre, where it is 1e-14.
struct GaussianBand {
    double center = 550.0;   ///< nm
    double deviation = 20.0; ///< nm, > 0
    double height = 1.0;

    friend bool operator==(const GaussianBand&, const GaussianBand&) = default;
};

struct WavelengthRange {
    double from = 0.0, to = 0.0; ///< nm; empty where to <= from

    [[nodiscard]] bool empty() const { return !(from < to); }
};

[[nodiscard]] WavelengthRange overlapOf(const WavelengthRange& a, const WavelengthRange& b);
/// The smallest range that holds both.
[[nodiscard]] WavelengthRange hullOf(const WavelengthRange& a, const WavelengthRange& b);

enum class Outside {
    Zero,    ///< lights and sensors: nothing is known, nothing is there
    Nearest, ///< reflectances: the last sample goes on, as CIE 15:2004 recommends
};

/// Linear between its samples, plus bands.
struct Spectrum {
    std::string name;
    std::vector<double> nm; ///< strictly rising, none or at least two
    std::vector<double> values;
    std::vector<GaussianBand> bands;
    Outside outside = Outside::Zero;

    [[nodiscard]] double at(double wavelength) const;

    /// Where it was measured or is not 0.
    [[nodiscard]] WavelengthRange range() const;

    /// Between neighbouring knots it is linear, or smooth on the scale of a deviation.
    [[nodiscard]] std::vector<double> knots() const;

    friend bool operator==(const Spectrum&, const Spectrum&) = default;
};

/// Red, green and blue: the light's primaries, or the sensor's filters.
using SpectrumTriple = std::array<Spectrum, 3>;

[[nodiscard]] Spectrum scaled(Spectrum spectrum, double factor);

/// The light divided into three bands, red, green, blue, whose sum it is. Between bands it passes over within 1 nm.
[[nodiscard]] SpectrumTriple dividedIntoBands(const Spectrum& light, double blueToGreen = 490.0,
                                              double greenToRed = 580.0);

} // namespace reflectance
