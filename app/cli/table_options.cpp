#include "app/cli/table_options.h"

#include "core/base/file.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

namespace reflectance::cli {
namespace {

constexpr std::size_t mostSamples = 20'000'000; ///< 1.4 GB as a table of nine channels

struct GridKind {
    std::string_view name;
    std::vector<std::size_t> counts; ///< when none are given
};

const std::vector<GridKind>& gridKinds()
{
    static const std::vector<GridKind> kinds{{"polar", {31}}, {"isotropic", {31, 37}}, {"half", {91, 46, 37}}};
    return kinds;
}

GridShape shapeOf(std::string_view kind, const std::vector<std::size_t>& counts)
{
    if (kind == "polar")
        return polarShape(counts[0]);
    return kind == "isotropic" ? isotropicShape(counts[0], counts[1])
                               : halfDifferenceShape(counts[0], counts[1], counts[2]);
}

} // namespace

void addSourceOptions(CLI::App& verb, SourceOptions& options)
{
    verb.add_option("file", options.file,
                    "CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT or Zemax; the content decides")
        ->required();
    verb.add_option("--surface", options.surface,
                    "which one, where a file holds several (a CUReT sample, a rotation of a Zemax file)")
        ->capture_default_str();
    verb.add_option("--wavelength", options.wavelength, "nm: take this one of a spectral file instead of its colour");
}

Result<Measurement> measurementFrom(const SourceOptions& options)
{
    return loadMeasurement(options.file, {options.surface, options.wavelength});
}

void addGridOptions(CLI::App& verb, GridOptions& options)
{
    verb.add_option(
        "--grid", options.grid,
        "polar[:THETAS], isotropic[:THETASxPHIS] or half[:HxDxP] (half and difference angles, for highlights)");
    verb.add_option("--interpolation", options.interpolation,
                    "between the samples: nearest, linear or cubic (monotone)")
        ->check(CLI::IsMember({"nearest", "linear", "cubic"}))
        ->capture_default_str();
}

Result<GridShape> parseGrid(const std::string& text)
{
    const auto pieces = split(text, ':');
    const auto kind = std::find_if(gridKinds().begin(), gridKinds().end(),
                                   [&](const GridKind& k) { return k.name == pieces.front(); });
    if (kind == gridKinds().end())
        return Error{"--grid " + text + ": there is no such grid; choose polar, isotropic or half"};
    std::vector<std::size_t> counts = kind->counts;
    if (pieces.size() > 1) {
        const auto given = split(pieces[1], 'x');
        if (pieces.size() > 2 || given.size() != counts.size())
            return Error{"--grid " + text + ": " + std::string(kind->name) + " takes " + std::to_string(counts.size()) +
                         (counts.size() == 1 ? " count" : " counts with x between")};
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const auto count = parseInteger(given[i]);
            if (!count || *count < 2 || *count > 10000)
                return Error{"--grid " + text + ": a count must be a whole number within 2 .. 10000"};
            counts[i] = static_cast<std::size_t>(*count);
        }
    }
    double samples = kind->name == "half" ? 1.0 : static_cast<double>(counts[0]);
    for (const std::size_t count : counts)
        samples *= static_cast<double>(count);
    if (samples > static_cast<double>(mostSamples))
        return Error{"--grid " + text + " asks for " + general(samples, 3) + " samples; " +
                     general(static_cast<double>(mostSamples), 3) + " are possible"};
    return shapeOf(kind->name, counts);
}

Interpolation interpolationNamed(const std::string& name)
{
    return name == "nearest" ? Interpolation::Nearest
           : name == "cubic" ? Interpolation::MonotoneCubic
                             : Interpolation::Linear;
}

Result<void> saveTable(const std::string& path, TableFormat format, const Table& table)
{
    if (const auto holds = checkHolds(format, table); !holds)
        return Error{holds.error().message, path};
    return writeAtomically(path, bytesOf(format, table));
}

std::string shapeText(const Table& table)
{
    std::vector<std::string> counts;
    for (const auto& axis : table.axes)
        counts.push_back(std::to_string(axis.size()));
    return std::string(nameOf(table.system)) + ", " + joined(counts, " x ");
}

} // namespace reflectance::cli
