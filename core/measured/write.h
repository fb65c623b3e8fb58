// Tables to files. What is written here, the readers give back: CSV and OpenMATERIAL 3D to the bit, MERL as far as its
// cells and its factors allow.
#pragma once

#include "core/measured/resample.h"

namespace reflectance {

enum class TableFormat { Csv, Merl, OpenMaterial };

/// From the ending of a path: .csv, .binary, and .json, .xompt. The sentence lists them.
[[nodiscard]] Result<TableFormat> tableFormatOf(const std::string& path);

/// Whether the format can hold the table: MERL wants half and difference angles, OpenMATERIAL polar or isotropic ones, and
/// neither a full matrix. The sentence says what to do.
[[nodiscard]] Result<void> checkHolds(TableFormat format, const Table& table);

/// The grid that a format wants when the measurement is none that it can hold: MERL's own 90 x 90 x 180 cells, 31 x 31 x 37
/// isotropic angles for OpenMATERIAL, 91 x 46 x 37 half and difference angles for CSV.
[[nodiscard]] GridShape naturalShape(TableFormat format);

/// The file's bytes; the table must pass checkHolds.
[[nodiscard]] std::string csvText(const Table& table);
[[nodiscard]] std::string merlBytes(const Table& table);
[[nodiscard]] std::string openMaterialText(const Table& table);
[[nodiscard]] std::string bytesOf(TableFormat format, const Table& table);

} // namespace reflectance
