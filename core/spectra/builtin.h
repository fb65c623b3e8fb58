// Spectra by name: those that the program carries, with their sources, and else a user's file.
#pragma once

#include "core/spectra/spectra_file.h"

#include <span>

namespace reflectance {

struct BuiltinSpectra {
    std::string_view name;
    SpectrumRole role;
    std::string_view about;  ///< one sentence
    std::string_view source; ///< where its numbers come from, or the formula
};

[[nodiscard]] std::span<const BuiltinSpectra> builtinSpectra();

/// Spectra with the warnings that reading them gave.
struct NamedReflectances {
    std::vector<Spectrum> spectra;
    std::vector<std::string> warnings;
};

/// "colorchecker", "grey:0.5", a patch of the chart by name, or a CSV file.
[[nodiscard]] Result<NamedReflectances> reflectancesNamed(const std::string& name);

/// "nikon_d5100", "sigma_sd_merrill", "cie_1931", "srgb", "gaussian:CROSSING", "narrow", or a CSV file with three columns.
[[nodiscard]] Result<SpectrumTriple> sensorNamed(const std::string& name);

/// Light primaries: "display", "leds", any single light (divided into bands), or a CSV file with one or three columns.
[[nodiscard]] Result<SpectrumTriple> primariesNamed(const std::string& name);

/// One light: "A", "D50", "D65", "FL2", "FL11", "E", "LED3", "LED_white", or a CSV file with one column.
[[nodiscard]] Result<Spectrum> lightNamed(const std::string& name);

/// Three Gaussian filters at 460, 540 and 620 nm, 1 at their peaks. `crossing` is the height at which neighbours cross,
/// 0 .. 0.95: 0 means 1 nm wide, so that they do not overlap.
[[nodiscard]] SpectrumTriple gaussianSensor(double crossing);

/// The chart of 24 patches.
[[nodiscard]] const std::vector<Spectrum>& colorChecker();

/// X, Y, Z of the CIE 1931 observer.
[[nodiscard]] const SpectrumTriple& standardObserver();

} // namespace reflectance
