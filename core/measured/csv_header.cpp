#include "core/measured/csv_header.h"

#include "core/base/text.h"
#include "core/measured/lines.h"

#include <algorithm>
#include <numbers>
#include <span>

namespace reflectance {
namespace {

struct NamedQuantity {
    std::string_view name;
    Quantity quantity;
};
constexpr NamedQuantity quantities[] = {{"f", Quantity::Brdf},
                                        {"f_cos_i", Quantity::TimesCosI},
                                        {"f_cos_r", Quantity::TimesCosR},
                                        {"factor", Quantity::Factor},
                                        {"relative", Quantity::Relative}};

/// Every angle and value column that a header may name, for "did you mean".
std::vector<std::string> possibleColumns()
{
    std::vector<std::string> names;
    for (const std::string_view angle :
         {"theta_i", "phi_i", "theta_r", "phi_r", "delta_phi", "theta_h", "theta_d", "phi_d", "radial", "azimuth"})
        for (const std::string_view unit : {"_deg", "_rad"})
            names.push_back(std::string(angle).append(unit));
    for (const NamedQuantity& named : quantities)
        for (const std::size_t channels : {1U, 3U, 9U})
            for (const std::string& name : valueNames(named.name, channels))
                names.push_back(name);
    return names;
}

struct Column {
    std::string name;
    std::size_t index;
};

/// Columns split into angles (unit taken off) and values.
struct Columns {
    std::vector<Column> angles, values;
    bool anyDegrees = false, anyRadians = false;
};

Result<Columns> sorted(std::string_view line)
{
    constexpr std::ptrdiff_t most = 13; // four angles and nine values
    if (std::count(line.begin(), line.end(), ',') >= most)
        return Error{"has more than the " + std::to_string(most) + " columns that a table can have"};
    Columns columns;
    const std::vector<std::string> known = possibleColumns();
    std::vector<std::string> seen;
    for (const std::string_view piece : split(line, ',')) {
        const std::string name = lowered(trimmed(piece));
        if (std::find(seen.begin(), seen.end(), name) != seen.end())
            return Error{"names the column " + quotedPiece(name) + " twice"};
        const std::size_t index = seen.size();
        seen.push_back(name);
        const bool isDegrees = name.ends_with("_deg");
        const bool isUnitless = std::find(known.begin(), known.end(), name + "_deg") != known.end();
        if (isUnitless)
            return Error{"the column " + quotedPiece(name) + " names no unit; write " + name + "_deg or " + name +
                         "_rad"};
        if (name != "f_r" && std::find(known.begin(), known.end(), name) == known.end())
            return Error{"there is no column " + quotedPiece(name) + "; did you mean " + nearestName(name, known) +
                         "?"};
        if (isDegrees || name.ends_with("_rad")) {
            columns.angles.push_back({name.substr(0, name.size() - 4), index});
            (isDegrees ? columns.anyDegrees : columns.anyRadians) = true;
        } else {
            columns.values.push_back({name == "f_r" ? "f" : name, index});
        }
    }
    return columns;
}

/// The column of each wanted name, if exactly these are there.
std::optional<std::vector<std::size_t>> matched(const std::vector<Column>& columns,
                                                const std::vector<std::string>& wanted)
{
    if (columns.size() != wanted.size())
        return std::nullopt;
    std::vector<std::size_t> found;
    for (const std::string& name : wanted) {
        const auto column =
            std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
        if (column == columns.end())
            return std::nullopt;
        found.push_back(column->index);
    }
    return found;
}

bool takeAngles(const Columns& columns, CsvHeader& header)
{
    const auto take = [&](std::span<const std::string_view> names) {
        const auto found = matched(columns.angles, {names.begin(), names.end()});
        if (found)
            header.angleColumn = *found;
        return found.has_value();
    };
    for (const Column& column : columns.angles)
        header.angleNames.push_back(column.name);
    for (const AngleSystem system :
         {AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference, AngleSystem::Specular})
        if (take(angleNames(system))) {
            header.system = system;
            return true;
        }
    header.isScattered = take(scatteredAngles);
    return header.isScattered;
}

bool takeValues(const Columns& columns, CsvHeader& header)
{
    for (const NamedQuantity& named : quantities)
        for (const std::size_t channels : {1U, 3U, 9U})
            if (const auto found = matched(columns.values, valueNames(named.name, channels))) {
                header.quantity = named.quantity;
                header.valueColumn = *found;
                return true;
            }
    return false;
}

} // namespace

std::vector<std::string> valueNames(std::string_view quantity, std::size_t channels)
{
    const std::string name(quantity);
    if (channels == 1)
        return {name};
    if (channels == 3)
        return {name + "_red", name + "_green", name + "_blue"};
    std::vector<std::string> names;
    for (const char row : {'1', '2', '3'})
        for (const char column : {'1', '2', '3'})
            names.push_back(name + '_' + row + column);
    return names;
}

Result<CsvHeader> parseCsvHeader(std::string_view line)
{
    const auto columns = sorted(line);
    if (!columns)
        return columns.error();
    if (columns->anyDegrees && columns->anyRadians)
        return Error{"some angles are in degrees and some in radians; give all in one unit"};
    CsvHeader header;
    header.columns = columns->angles.size() + columns->values.size();
    header.inDegrees = columns->anyDegrees;
    if (!takeAngles(*columns, header))
        return Error{"its angle columns make no table; give theta_i and theta_r, or these and delta_phi, or theta_h, "
                     "theta_d and phi_d, or theta_i, phi_i, theta_r and phi_r, each with _deg or _rad"};
    if (!takeValues(*columns, header))
        return Error{"its value columns make no table; give one number (f), three (f_red, f_green, f_blue) or nine "
                     "(f_11 .. f_33), with f, f_cos_i, f_cos_r, factor or relative before"};
    const bool needsDirections = header.quantity != Quantity::Brdf && header.quantity != Quantity::Relative;
    if (needsDirections && header.system == AngleSystem::HalfDifference)
        return Error{"half and difference angles do not tell light from viewer, so a cosine cannot be divided out; "
                     "give f or relative"};
    return header;
}

std::string describe(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Brdf:
        return "BRDF in 1/sr";
    case Quantity::TimesCosI:
        return "BRDF x cos(theta_i)";
    case Quantity::TimesCosR:
        return "BRDF x cos(theta_r)";
    case Quantity::Factor:
        return "the factor pi x BRDF x cos(theta_i)";
    case Quantity::Relative:
        return "relative to a white tile: pi x BRDF";
    }
    return {};
}

std::optional<double> brdfFrom(Quantity quantity, double value, const DirectionPair& directions)
{
    constexpr double pi = std::numbers::pi;
    constexpr double horizon = 1e-9; // radians: at 90 degrees the product is 0 whatever f is
    const double cosine = quantity == Quantity::TimesCosR ? directions.V.z : directions.L.z;
    switch (quantity) {
    case Quantity::Brdf:
        return value;
    case Quantity::Relative:
        return value / pi;
    case Quantity::TimesCosI:
    case Quantity::TimesCosR:
        return cosine > horizon ? std::optional(value / cosine) : std::nullopt;
    case Quantity::Factor:
        return cosine > horizon ? std::optional(value / (pi * cosine)) : std::nullopt;
    }
    return std::nullopt;
}

} // namespace reflectance
