// The header of a table in CSV: which columns are angles, in which unit, and what the numbers are. docs/tables.md gives the
// grammar. Internal to the reader and the writer.
#pragma once

#include "core/base/result.h"
#include "core/measured/angles.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// What the numbers of a file are; f is the BRDF in 1/sr.
enum class Quantity { Brdf, TimesCosI, TimesCosR, Factor, Relative };

/// The angles of a scattered file, in the order of CsvHeader::angleColumn.
inline constexpr std::string_view scatteredAngles[] = {"theta_i", "phi_i", "theta_r", "phi_r"};

struct CsvHeader {
    bool isScattered = false; ///< theta_i, phi_i, theta_r, phi_r in any order of rows, instead of a grid
    AngleSystem system = AngleSystem::Polar;
    std::vector<std::string> angleNames;  ///< as the columns stand, without the unit
    std::vector<std::size_t> angleColumn; ///< per angle of the system (scattered: of the four): its column
    std::vector<std::size_t> valueColumn; ///< per channel: its column
    std::size_t columns = 0;
    bool inDegrees = false;
    Quantity quantity = Quantity::Brdf;
};

[[nodiscard]] Result<CsvHeader> parseCsvHeader(std::string_view line);

/// The names of the value columns for so many channels: "f"; "f_red", ...; "f_11", "f_12", ...
[[nodiscard]] std::vector<std::string> valueNames(std::string_view quantity, std::size_t channels);

/// "BRDF in 1/sr", "BRDF x cos(theta_r)", ...
[[nodiscard]] std::string describe(Quantity quantity);

/// f from a number of the file at these directions; nothing where the quantity is 0 by definition, at the horizon.
[[nodiscard]] std::optional<double> brdfFrom(Quantity quantity, double value, const DirectionPair& directions);

} // namespace reflectance
