#include "core/measured/write.h"

#include "core/base/text.h"
#include "core/measured/csv_header.h"

namespace reflectance {
namespace {

/// The angles of a sample in the order of the axes.
Angles anglesAt(const Table& table, std::size_t sample)
{
    Angles at{};
    for (std::size_t axis = table.axes.size(); axis-- > 0;) {
        at[axis] = table.axes[axis][sample % table.axes[axis].size()];
        sample /= table.axes[axis].size();
    }
    return at;
}

} // namespace

Result<TableFormat> tableFormatOf(const std::string& path)
{
    const std::string name = lowered(path);
    if (name.ends_with(".csv"))
        return TableFormat::Csv;
    if (name.ends_with(".binary"))
        return TableFormat::Merl;
    if (name.ends_with(".json") || name.ends_with(".xompt"))
        return TableFormat::OpenMaterial;
    return Error{"is no ending that a table is written with; choose .csv, .binary (MERL), or .json or .xompt "
                 "(OpenMATERIAL 3D)",
                 path};
}

Result<void> checkHolds(TableFormat format, const Table& table)
{
    if (format == TableFormat::Csv)
        return {};
    if (table.channels == 9)
        return Error{"a full matrix per direction fits into neither MERL nor OpenMATERIAL 3D; write a .csv"};
    const bool isHalf = table.system == AngleSystem::HalfDifference;
    if (format == TableFormat::Merl && !isHalf)
        return Error{"MERL holds half and difference angles; choose the grid half"};
    if (format == TableFormat::OpenMaterial && (isHalf || table.system == AngleSystem::Specular))
        return Error{"OpenMATERIAL 3D holds polar or isotropic angles; choose the grid isotropic"};
    return {};
}

GridShape naturalShape(TableFormat format)
{
    switch (format) {
    case TableFormat::Csv:
        break;
    case TableFormat::Merl:
        return halfDifferenceShape(91, 91, 181);
    case TableFormat::OpenMaterial:
        return isotropicShape(31, 37);
    }
    return halfDifferenceShape(91, 46, 37);
}

std::string csvText(const Table& table)
{
    std::string text =
        "# name " + table.provenance.name + "\n# interpolation " + std::string(nameOf(table.interpolation)) + "\n";
    for (const std::string_view angle : angleNames(table.system))
        text.append(angle).append("_rad,");
    text += joined(valueNames("f", table.channels), ",") + "\n";
    for (std::size_t sample = 0; sample < table.samples(); ++sample) {
        const Angles at = anglesAt(table, sample);
        for (std::size_t axis = 0; axis < table.axes.size(); ++axis)
            text.append(shortest(at[axis])).append(",");
        for (std::size_t c = 0; c < table.channels; ++c) {
            const double value = table.values[sample * table.channels + c];
            text.append(std::isnan(value) ? "nan" : shortest(value)).append(c + 1 < table.channels ? "," : "\n");
        }
    }
    return text;
}

std::string bytesOf(TableFormat format, const Table& table)
{
    switch (format) {
    case TableFormat::Csv:
        return csvText(table);
    case TableFormat::Merl:
        return merlBytes(table);
    case TableFormat::OpenMaterial:
        return openMaterialText(table);
    }
    return {};
}

} // namespace reflectance
