// Spectra as CSV: the wavelength in the first column, a spectrum in every other.
#pragma once

#include "core/base/result.h"
#include "core/spectra/spectrum.h"

#include <string_view>

namespace reflectance {

enum class SpectrumRole { Reflectance, Sensor, Light };

struct SpectraFile {
    std::vector<Spectrum> spectra;     ///< at least one
    std::vector<std::string> warnings; ///< what was read but looks wrong
};

/// Reads CSV text. Commas, semicolons, tabs or blanks part the columns; lines that start with # are notes. The first
/// line may name the columns, and states units: "um" in the first name, "%" or "percent" anywhere. Without a statement
/// wavelengths are nanometres, or micrometres where all are below 10, and values are fractions.
///
/// Errors, each with its line: fewer than two samples, wavelengths that do not rise, missing, non-numeric or infinite
/// values, a negative sensitivity or power. A reflectance above 2 or below 0 is a warning.
[[nodiscard]] Result<SpectraFile> parseSpectra(std::string_view csv, SpectrumRole role, const std::string& file);

/// The same of a file of up to 16 MB; memory stays below 24 times the file.
[[nodiscard]] Result<SpectraFile> readSpectra(const std::string& path, SpectrumRole role);

} // namespace reflectance
