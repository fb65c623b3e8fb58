#include "core/spectra/builtin.h"

#include "core/base/check.h"
#include "core/base/embedded.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace reflectance {

std::span<const EmbeddedFile> spectraFiles();

namespace {

constexpr std::string_view npl = "Darrodi, Finlayson, Goodman, Mackiewicz, JOSA A 32(3), 2015";
constexpr std::string_view cie15 = "CIE 15:2004";
constexpr std::string_view own = "analytic, of this program: no measured lamp";

constexpr BuiltinSpectra all[] = {
    {"colorchecker", SpectrumRole::Reflectance, "24 patches of the ColorChecker, 380 .. 730 nm",
     "mean of 30 charts, BabelColor"},
    {"grey:SHARE", SpectrumRole::Reflectance, "the same share at every wavelength", "exact"},
    {"nikon_d5100", SpectrumRole::Sensor, "a camera with filters over its pixels", npl},
    {"sigma_sd_merrill", SpectrumRole::Sensor, "a camera with three stacked layers, which overlap strongly", npl},
    {"cie_1931", SpectrumRole::Sensor, "X, Y, Z of the standard observer, 2 degrees", cie15},
    {"srgb", SpectrumRole::Sensor, "what linear sRGB would see; negative in places", "CIE 1931 and IEC 61966-2-1"},
    {"gaussian:CROSSING", SpectrumRole::Sensor, "three Gaussian filters; neighbours cross at this height", own},
    {"narrow", SpectrumRole::Sensor, "three bands of 10 nm at 450, 550 and 610 nm", own},
    {"display", SpectrumRole::Light, "three primaries as a display has them: Gaussians, 18 to 38 nm", own},
    {"leds", SpectrumRole::Light, "three primaries as coloured LEDs have them: Gaussians, 9 to 14 nm", own},
    {"A", SpectrumRole::Light, "incandescent lamp, 2856 K", cie15},
    {"D50", SpectrumRole::Light, "daylight, 5000 K", cie15},
    {"D65", SpectrumRole::Light, "daylight, 6500 K", cie15},
    {"FL2", SpectrumRole::Light, "cool white fluorescent lamp", cie15},
    {"FL11", SpectrumRole::Light, "fluorescent lamp with three narrow bands", cie15},
    {"E", SpectrumRole::Light, "equal energy, 380 .. 780 nm", "exact"},
    {"LED3", SpectrumRole::Light, "white of three narrow LEDs: the sum of leds", own},
    {"LED_white", SpectrumRole::Light, "blue LED with a yellow phosphor", own},
};

std::vector<Spectrum> embeddedSpectra(std::string_view name, SpectrumRole role)
{
    const auto files = spectraFiles();
    const auto found = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) { return f.name == name; });
    CHECK_LT(found - files.begin(), static_cast<std::ptrdiff_t>(files.size()));
    auto parsed = parseSpectra(found->bytes, role, std::string(name));
    CHECK_EQ(parsed.has_value(), true);
    return std::move(parsed->spectra);
}

SpectrumTriple tripleOf(std::vector<Spectrum> spectra)
{
    return {std::move(spectra[0]), std::move(spectra[1]), std::move(spectra[2])};
}

Spectrum band(const char* name, std::vector<GaussianBand> bands)
{
    Spectrum spectrum;
    spectrum.name = name;
    spectrum.bands = std::move(bands);
    return spectrum;
}

SpectrumTriple display()
{
    return {band("red", {{610.0, 18.0, 1.0}}), band("green", {{540.0, 38.0, 1.0}}), band("blue", {{455.0, 20.0, 1.0}})};
}

SpectrumTriple leds()
{
    return {band("red", {{630.0, 9.0, 1.0}}), band("green", {{525.0, 14.0, 1.0}}), band("blue", {{465.0, 10.0, 1.0}})};
}

Spectrum sumOf(const char* name, const SpectrumTriple& parts)
{
    Spectrum sum = band(name, {});
    for (const Spectrum& part : parts)
        sum.bands.insert(sum.bands.end(), part.bands.begin(), part.bands.end());
    return sum;
}

Spectrum flat(const std::string& name, double value, Outside outside)
{
    Spectrum spectrum;
    spectrum.name = name;
    spectrum.nm = {380.0, 780.0};
    spectrum.values = {value, value};
    spectrum.outside = outside;
    return spectrum;
}

Spectrum boxOf(const char* name, double center)
{
    constexpr double half = 5.0;
    constexpr double edge = 0.01; // steep, but still a function
    Spectrum spectrum;
    spectrum.name = name;
    spectrum.nm = {center - half - edge, center - half, center + half, center + half + edge};
    spectrum.values = {0.0, 1.0, 1.0, 0.0};
    return spectrum;
}

/// Linear sRGB as the observer's sensitivities combined: rows of the inverse of the matrix of IEC 61966-2-1.
SpectrumTriple srgbSensor()
{
    constexpr double fromXyz[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    constexpr const char* names[] = {"red", "green", "blue"};
    const SpectrumTriple& xyz = standardObserver();
    SpectrumTriple rgb = xyz;
    for (std::size_t c = 0; c < 3; ++c) {
        rgb[c].name = names[c];
        for (std::size_t i = 0; i < rgb[c].nm.size(); ++i)
            rgb[c].values[i] =
                fromXyz[c][0] * xyz[0].values[i] + fromXyz[c][1] * xyz[1].values[i] + fromXyz[c][2] * xyz[2].values[i];
    }
    return rgb;
}

const std::vector<Spectrum>& illuminants()
{
    static const std::vector<Spectrum> lights = [] {
        auto list = embeddedSpectra("illuminants.csv", SpectrumRole::Light);
        list.push_back(flat("E", 1.0, Outside::Zero));
        list.push_back(sumOf("LED3", leds()));
        list.push_back(band("LED_white", {{452.0, 10.0, 1.0}, {555.0, 48.0, 0.55}}));
        return list;
    }();
    return lights;
}

const Spectrum* findNamed(const std::vector<Spectrum>& list, std::string_view name)
{
    const auto found = std::find_if(list.begin(), list.end(), [&](const Spectrum& s) { return s.name == name; });
    return found == list.end() ? nullptr : &*found;
}

/// No built-in of that name: a file, if there is one.
Result<SpectraFile> fromFile(const std::string& name, SpectrumRole role, std::string_view kind)
{
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored))
        return readSpectra(name, role);
    std::vector<std::string> names;
    for (const BuiltinSpectra& builtin : all)
        if (builtin.role == role)
            names.emplace_back(builtin.name);
    return Error{"there is no " + std::string(kind) + " '" + name + "' and no such file; give a CSV file or one of " +
                 joined(names)};
}

/// The number after "PREFIX:", within 0 .. most.
Result<double> numberAfter(const std::string& name, std::string_view prefix, double most)
{
    const auto number = parseNumber(std::string_view(name).substr(prefix.size()));
    if (!number || !(*number >= 0.0 && *number <= most))
        return Error{"'" + name + "': give a number within 0 .. " + general(most, 3) + " after '" +
                     std::string(prefix) + "'"};
    return *number;
}

} // namespace

std::span<const BuiltinSpectra> builtinSpectra()
{
    return all;
}

const std::vector<Spectrum>& colorChecker()
{
    static const std::vector<Spectrum> chart = embeddedSpectra("colorchecker.csv", SpectrumRole::Reflectance);
    return chart;
}

const SpectrumTriple& standardObserver()
{
    static const SpectrumTriple observer = tripleOf(embeddedSpectra("cie_1931.csv", SpectrumRole::Sensor));
    return observer;
}

SpectrumTriple gaussianSensor(double crossing)
{
    constexpr double apart = 80.0;
    // At half the distance the height is exp(-(apart / 2 / deviation)^2 / 2) = crossing.
    const double deviation = crossing > 0.0 ? 0.5 * apart / std::sqrt(-2.0 * std::log(crossing)) : 0.0;
    const double width = std::max(deviation, 1.0);
    return {band("red", {{620.0, width, 1.0}}), band("green", {{540.0, width, 1.0}}),
            band("blue", {{460.0, width, 1.0}})};
}

Result<NamedReflectances> reflectancesNamed(const std::string& name)
{
    if (name == "colorchecker")
        return NamedReflectances{colorChecker(), {}};
    if (name.starts_with("grey:")) {
        const auto share = numberAfter(name, "grey:", 2.0);
        if (!share)
            return share.error();
        return NamedReflectances{{flat(name, *share, Outside::Nearest)}, {}};
    }
    if (const Spectrum* patch = findNamed(colorChecker(), name))
        return NamedReflectances{{*patch}, {}};
    auto file = fromFile(name, SpectrumRole::Reflectance, "reflectance");
    if (!file)
        return file.error();
    return NamedReflectances{std::move(file->spectra), std::move(file->warnings)};
}

Result<SpectrumTriple> sensorNamed(const std::string& name)
{
    for (const char* measured : {"nikon_d5100", "sigma_sd_merrill", "cie_1931"})
        if (name == measured)
            return tripleOf(embeddedSpectra(name + ".csv", SpectrumRole::Sensor));
    if (name == "srgb")
        return srgbSensor();
    if (name == "narrow")
        return SpectrumTriple{boxOf("red", 610.0), boxOf("green", 550.0), boxOf("blue", 450.0)};
    if (name.starts_with("gaussian:")) {
        const auto crossing = numberAfter(name, "gaussian:", 0.95);
        if (!crossing)
            return crossing.error();
        return gaussianSensor(*crossing);
    }
    auto file = fromFile(name, SpectrumRole::Sensor, "sensor");
    if (!file)
        return file.error();
    if (file->spectra.size() != 3)
        return Error{"a sensor has three spectra (red, green, blue) and there are " +
                         std::to_string(file->spectra.size()),
                     name};
    return tripleOf(std::move(file->spectra));
}

Result<SpectrumTriple> primariesNamed(const std::string& name)
{
    if (name == "display")
        return display();
    if (name == "leds")
        return leds();
    if (const Spectrum* light = findNamed(illuminants(), name))
        return dividedIntoBands(*light);
    auto file = fromFile(name, SpectrumRole::Light, "light");
    if (!file)
        return file.error();
    if (file->spectra.size() == 1)
        return dividedIntoBands(file->spectra.front());
    if (file->spectra.size() != 3)
        return Error{"primaries are three spectra (red, green, blue), or one that is divided into bands; there are " +
                         std::to_string(file->spectra.size()),
                     name};
    return tripleOf(std::move(file->spectra));
}

Result<Spectrum> lightNamed(const std::string& name)
{
    if (const Spectrum* light = findNamed(illuminants(), name))
        return *light;
    auto file = fromFile(name, SpectrumRole::Light, "light");
    if (!file)
        return file.error();
    if (file->spectra.size() != 1)
        return Error{"one light has one spectrum and there are " + std::to_string(file->spectra.size()), name};
    return std::move(file->spectra.front());
}

} // namespace reflectance
