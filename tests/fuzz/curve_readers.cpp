#include "tests/fuzz/curve_readers.h"

#include "core/sensor/response_curve.h"
#include "core/spectra/spectra_file.h"
#include "tests/fuzz/promises.h"

#include <algorithm>
#include <cmath>

namespace reflectance::fuzz {
namespace {

Outcome refused(const Error& error)
{
    const std::string broken = brokenPromise(error);
    return {false, broken.empty() ? "" : broken + ": " + error.sentence()};
}

/// Rising wavelengths, as many finite values, none negative but of a reflectance.
std::string brokenSpectrum(const Spectrum& spectrum, SpectrumRole role)
{
    if (spectrum.nm.size() < 2 || spectrum.nm.size() != spectrum.values.size())
        return "a spectrum with another number of values than of wavelengths";
    for (std::size_t i = 0; i < spectrum.nm.size(); ++i) {
        if (!std::isfinite(spectrum.nm[i]) || !(spectrum.nm[i] > (i > 0 ? spectrum.nm[i - 1] : 0.0)))
            return "wavelengths that do not rise";
        if (!std::isfinite(spectrum.values[i]) || (role != SpectrumRole::Reflectance && spectrum.values[i] < 0.0))
            return "a value that is negative or not finite";
    }
    return "";
}

template <SpectrumRole role> Outcome readSpectraAs(std::string_view bytes)
{
    const auto file = parseSpectra(bytes, role, "a.csv");
    if (!file)
        return refused(file.error());
    for (const Spectrum& spectrum : file->spectra)
        if (const std::string broken = brokenSpectrum(spectrum, role); !broken.empty())
            return {true, broken};
    return {true, file->spectra.empty() ? "a file without a spectrum" : ""};
}

/// Never falling from texel to texel, within 0 .. 1.
Outcome readResponse(std::string_view bytes)
{
    const auto curve = parseResponseCurve(bytes, "a.csv");
    if (!curve)
        return refused(curve.error());
    if (curve->count() < 2 || curve->numbers.size() != curve->texels.size())
        return {true, "a curve of fewer than two places"};
    for (std::size_t i = 0; i < curve->texels.size(); ++i)
        if (!(curve->texels[i] >= (i >= 4 ? curve->texels[i - 4] : 0.0F) && curve->texels[i] <= 1.0F))
            return {true, "a response that falls, or lies outside 0 .. 1"};
    return {true, ""};
}

} // namespace

std::vector<Reader> curveReaders()
{
    return {{"spectra",
             readSpectraAs<SpectrumRole::Reflectance>,
             {"wavelength (nm),red\n400,0.1\n550,0.25\n700,0.5\n", "# percent\num;a %;b %\n0.4;10;20\n0.7;30;40\n"}},
            {"sensor_spectra",
             readSpectraAs<SpectrumRole::Sensor>,
             {"nm r g b\n400 0 0 1\n500 0 1 0.5\n600 1 0.5 0\n", "400\t1\n700\t2\n"}},
            {"response",
             readResponse,
             {"light,response\n0,0\n0.5,0.8\n1,1\n", "# c\n0 0 0 1\n512 60 70 80\n1023 255 255 255\n"}}};
}

} // namespace reflectance::fuzz
