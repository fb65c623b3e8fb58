#include "core/spectra/spectra_file.h"

#include "core/base/columns.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

struct Line {
    long number = 0;
    std::vector<std::string_view> fields;
};

std::vector<Line> linesOf(std::string_view csv)
{
    std::vector<Line> lines;
    long number = 0;
    for (const std::string_view text : split(withoutMark(csv), '\n')) {
        ++number;
        if (const auto line = trimmed(text); !line.empty() && !line.starts_with('#'))
            lines.push_back({number, columnsOf(line)});
    }
    return lines;
}

struct Header {
    std::vector<std::string> names;
    double nmPerUnit = 0.0; ///< 0: not stated
    double perPercent = 1.0;
};

Header headerOf(const std::vector<std::string_view>& fields)
{
    Header header;
    header.names.assign(fields.begin(), fields.end());
    std::string all;
    for (const std::string& name : header.names)
        all += lowered(name) + ' ';
    if (all.find('%') != std::string::npos || all.find("percent") != std::string::npos)
        header.perPercent = 0.01;
    const std::string first = lowered(fields.front());
    const auto states = [&first](std::string_view unit) { return first.find(unit) != std::string::npos; };
    if (states("nm") || states("nanomet"))
        header.nmPerUnit = 1.0;
    else if (states("um") || states("\xC2\xB5m") || states("\xCE\xBCm") || states("micro"))
        header.nmPerUnit = 1000.0;
    return header;
}

/// "12.3, spectrum 'red'" for messages.
std::string placeOf(double nm, const Spectrum& spectrum)
{
    return "spectrum '" + spectrum.name + "' at " + general(nm, 6) + " nm";
}

Result<void> addLine(const Line& line, std::vector<double>& wavelengths, std::vector<Spectrum>& spectra)
{
    if (line.fields.size() < spectra.size() + 1)
        return Error{"there are " + std::to_string(line.fields.size()) + " columns where " +
                     std::to_string(spectra.size() + 1) + " are expected; give every spectrum a value on each line"};
    for (std::size_t i = 0; i <= spectra.size(); ++i) {
        const auto number = parseNumber(line.fields[i]);
        if (!number || !std::isfinite(*number))
            return Error{"'" + std::string(line.fields[i]) + "' is not a finite number"};
        (i == 0 ? wavelengths : spectra[i - 1].values).push_back(*number);
    }
    const std::size_t count = wavelengths.size();
    if (count > 1 && !(wavelengths[count - 1] > wavelengths[count - 2]))
        return Error{"wavelength " + general(wavelengths[count - 1], 6) + " follows " +
                     general(wavelengths[count - 2], 6) + "; sort the lines by wavelength and keep each only once"};
    if (!(wavelengths.back() > 0.0))
        return Error{"the wavelength " + general(wavelengths.back(), 6) + " is not above 0"};
    return {};
}

/// A light or sensor may not be negative; a reflectance outside 0 .. 2 is read, and said.
Result<void> checkValues(const Spectrum& spectrum, SpectrumRole role, std::vector<std::string>& warnings)
{
    const auto lowest = std::min_element(spectrum.values.begin(), spectrum.values.end());
    const auto highest = std::max_element(spectrum.values.begin(), spectrum.values.end());
    const auto at = [&](auto found) {
        return placeOf(spectrum.nm[static_cast<std::size_t>(found - spectrum.values.begin())], spectrum);
    };
    if (role != SpectrumRole::Reflectance) {
        if (*lowest < 0.0)
            return Error{at(lowest) + " is " + general(*lowest, 4) + "; a " +
                         (role == SpectrumRole::Sensor ? "sensitivity" : "light's power") + " cannot be negative"};
        if (!(*highest > 0.0))
            return Error{"spectrum '" + spectrum.name + "' is 0 everywhere; leave it out or give its values"};
        return {};
    }
    if (*highest > 2.0)
        warnings.push_back(at(highest) + " is " + general(*highest, 4) +
                           ", above 2: if these are percent, say so by a % in the header");
    if (*lowest < 0.0)
        warnings.push_back(at(lowest) + " is " + general(*lowest, 4) + ", below 0: no surface reflects that");
    return {};
}

double nmPerUnitOf(const Header& header, const std::vector<double>& wavelengths)
{
    if (header.nmPerUnit > 0.0)
        return header.nmPerUnit;
    return wavelengths.back() < 10.0 ? 1000.0 : 1.0;
}

} // namespace

Result<SpectraFile> parseSpectra(std::string_view csv, SpectrumRole role, const std::string& file)
{
    std::vector<Line> lines = linesOf(csv);
    const auto refused = [&file](const Error& error, long line) { return Error{error.message, file, line}; };
    Header header;
    if (!lines.empty() && !parseNumber(lines.front().fields.front())) {
        header = headerOf(lines.front().fields);
        lines.erase(lines.begin());
    }
    if (lines.size() < 2)
        return Error{"there are " + std::to_string(lines.size()) +
                         " samples; a spectrum needs at least two wavelengths, one on each line",
                     file};
    const std::size_t columns = header.names.empty() ? lines.front().fields.size() : header.names.size();
    if (columns < 2)
        return refused({"there is only one column; give the wavelength and at least one value"}, lines.front().number);

    SpectraFile result;
    result.spectra.resize(columns - 1);
    for (std::size_t i = 0; i + 1 < columns; ++i) {
        result.spectra[i].name = header.names.empty() ? "column " + std::to_string(i + 2) : header.names[i + 1];
        result.spectra[i].outside = role == SpectrumRole::Reflectance ? Outside::Nearest : Outside::Zero;
    }
    std::vector<double> wavelengths;
    for (const Line& line : lines)
        if (const auto added = addLine(line, wavelengths, result.spectra); !added)
            return refused(added.error(), line.number);
    const double unit = nmPerUnitOf(header, wavelengths);
    for (double& wavelength : wavelengths)
        wavelength *= unit;
    for (Spectrum& spectrum : result.spectra) {
        spectrum.nm = wavelengths;
        for (double& value : spectrum.values)
            value *= header.perPercent;
        if (const auto good = checkValues(spectrum, role, result.warnings); !good)
            return refused(good.error(), 0);
    }
    return result;
}

Result<SpectraFile> readSpectra(const std::string& path, SpectrumRole role)
{
    const auto bytes = readWholeFile(path, std::uintmax_t{16} << 20U);
    if (!bytes)
        return bytes.error();
    return parseSpectra(*bytes, role, path);
}

} // namespace reflectance
