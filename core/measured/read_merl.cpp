// MERL: three 32-bit dimensions, then the planes of red, green and blue as 64-bit numbers; all little-endian.
#include "core/measured/bytes.h"
#include "core/measured/merl.h"
#include "core/measured/readers.h"

#include <limits>
#include <numbers>

namespace reflectance {
namespace merl {

std::vector<double> thetaHNodes(std::size_t count)
{
    std::vector<double> nodes;
    for (std::size_t i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        nodes.push_back(share * share * (std::numbers::pi / 2.0));
    }
    return nodes;
}

std::vector<double> evenNodes(std::size_t count, double end)
{
    std::vector<double> nodes;
    for (std::size_t i = 0; i <= count; ++i)
        nodes.push_back(end * (static_cast<double>(i) / static_cast<double>(count)));
    return nodes;
}

} // namespace merl

namespace {

constexpr std::size_t headerBytes = 12;
constexpr std::size_t channelBytes = 8;

/// The dimensions one by one: a product alone would let -90 -90 180 pass.
Result<merl::Size> sizeIn(std::string_view bytes, const std::string& file)
{
    std::size_t dimensions[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = littleEndian<std::int32_t>(bytes, 4 * i);
        if (!value)
            return Error{"is cut short within its dimensions; get the whole file", file};
        if (*value < 1 || *value > 65536)
            return Error{"is no MERL table: its dimension " + std::to_string(i + 1) + " is " + std::to_string(*value),
                         file};
        dimensions[i] = static_cast<std::size_t>(*value);
    }
    const merl::Size size{dimensions[0], dimensions[1], dimensions[2]};
    if (size.cells() == merl::Size().cells() && (dimensions[0] != 90 || dimensions[1] != 90))
        return Error{"is no MERL table: its dimensions are " + std::to_string(dimensions[0]) + " x " +
                         std::to_string(dimensions[1]) + " x " + std::to_string(dimensions[2]) +
                         " instead of 90 x 90 x 180",
                     file};
    const std::size_t expected = headerBytes + 3 * channelBytes * size.cells();
    if (bytes.size() != expected)
        return Error{"its dimensions ask for " + std::to_string(expected) + " bytes, but it has " +
                         std::to_string(bytes.size()) + "; get the whole file",
                     file};
    return size;
}

/// f of one channel; negative values mark pairs of directions that were not measured.
double valueIn(std::string_view bytes, std::size_t cell, std::size_t channel, std::size_t cells)
{
    const double raw = *littleEndian<double>(bytes, headerBytes + channelBytes * (channel * cells + cell));
    return raw >= 0.0 && std::isfinite(raw) ? raw * merl::scale[channel] : std::numeric_limits<double>::quiet_NaN();
}

/// Of the file's cells: the table repeats some of them at its rim.
Provenance counted(std::string_view bytes, std::size_t cells)
{
    Provenance provenance;
    provenance.samples = cells;
    std::size_t strange = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        bool isHole = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double raw = *littleEndian<double>(bytes, headerBytes + channelBytes * (c * cells + cell));
            isHole = isHole || !(raw >= 0.0 && std::isfinite(raw));
            strange += std::isfinite(raw) ? 0 : 1;
        }
        provenance.holes += isHole ? 1 : 0;
    }
    if (strange > 0)
        provenance.warnings.push_back(std::to_string(strange) + " numbers are not finite; they count as holes");
    return provenance;
}

} // namespace

bool looksLikeMerl(std::string_view bytes)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = littleEndian<std::int32_t>(bytes, 4 * i);
        if (!value || *value < -65536 || *value > 65536 || *value == 0)
            return false;
    }
    return true;
}

Result<Measurement> readMerl(std::string_view bytes, const ReadContext& context)
{
    const auto size = sizeIn(bytes, context.file);
    if (!size)
        return size.error();
    const std::size_t cells = size->cells();
    Table table;
    table.system = AngleSystem::HalfDifference;
    table.channels = 3;
    table.axes = {merl::thetaHNodes(size->thetaH), merl::evenNodes(size->thetaD, std::numbers::pi / 2.0),
                  merl::evenNodes(size->phiD, std::numbers::pi)};
    table.values.reserve(3 * (size->thetaH + 1) * (size->thetaD + 1) * (size->phiD + 1));
    for (std::size_t h = 0; h <= size->thetaH; ++h)
        for (std::size_t d = 0; d <= size->thetaD; ++d)
            for (std::size_t p = 0; p <= size->phiD; ++p) {
                const std::size_t row = std::min(h, size->thetaH - 1) * size->thetaD + std::min(d, size->thetaD - 1);
                const std::size_t cell = row * size->phiD + p % size->phiD;
                for (std::size_t c = 0; c < 3; ++c)
                    table.values.push_back(valueIn(bytes, cell, c, cells));
            }
    table.provenance = counted(bytes, cells);
    table.provenance.name = context.file;
    table.provenance.format = "MERL binary";
    table.provenance.convention = "BRDF x 1500, 1500/1.15, 1500/1.66 (red, green, blue); half and difference angles; "
                                  "negative: not measured; each sample holds for its cell";
    return finished(std::move(table), context);
}

} // namespace reflectance
