#include "tests/fuzz/table_readers.h"

#include "core/measured/readers.h"
#include "tests/fuzz/promises.h"
#include "tests/measured/made_files.h"

#include <algorithm>
#include <cmath>

namespace reflectance::fuzz {
namespace {

constexpr std::string_view halves = "\n=====\n"; ///< between CUReT's two files

bool isFinite(const Mat3d& f)
{
    return std::all_of(std::begin(f.rows), std::end(f.rows), [](const Vec3d& row) {
        return std::isfinite(row.x) && std::isfinite(row.y) && std::isfinite(row.z);
    });
}

std::string brokenTable(const Table& table)
{
    if (const auto checked = checkedTable(table); !checked)
        return "a table that is none: " + checked.error().message;
    for (std::size_t sample = 0; sample < table.samples(); ++sample)
        for (std::size_t c = 0; c < table.channels; ++c) {
            const double value = table.values[sample * table.channels + c];
            if (table.isHole(sample) != std::isnan(value) || std::isinf(value))
                return "a sample that is half a hole, or infinite";
        }
    return {};
}

Outcome judged(const Result<Measurement>& measurement, std::size_t bytes)
{
    if (measurement)
        return {true, brokenPromise(*measurement, bytes)};
    const std::string broken = brokenPromise(measurement.error());
    return {false, broken.empty() ? "" : broken + ": " + measurement.error().sentence()};
}

Outcome readTable(std::string_view bytes)
{
    return judged(readMeasurement(bytes, "a.table"), bytes.size());
}

Outcome readCuretPair(std::string_view bytes)
{
    const std::size_t at = std::min(bytes.find(halves), bytes.size());
    const std::string_view surfaces = bytes.substr(std::min(at + halves.size(), bytes.size()));
    return judged(readCuret(bytes.substr(0, at), "table.txt", surfaces, {"abrdf.dat", {}}), bytes.size());
}

std::vector<std::string> rglSeeds()
{
    std::vector<float> colours(12, 0.5F);
    colours[3] = -0.25F;
    return {testing::tensorFile(testing::rglFields({{0.0F, {1, 2, 3, 7}, colours}})),
            testing::tensorFile(testing::rglFields({{0.0F, {1, 2, 3, 7}, colours}, {1.5F, {1, 1, 1, 1}, colours}}))};
}

std::vector<std::string> csvSeeds()
{
    return {
        "# name brick\n# interpolation cubic\ntheta_i_deg,theta_r_deg,f\n0,0,0.1\n0,90,nan\n45,0,-0.1\n45,90,0.2\n",
        "theta_i_rad,theta_r_rad,delta_phi_rad,factor_red,factor_green,factor_blue\r\n"
        "0,0.5,0,1,2,3\r\n0,0.5,3,1,2,3\r\n1.5,0.5,0,1,2,3\r\n1.5,0.5,3,1,2,3\r\n",
        "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,relative\n30,0,30,180,0.5\n10,0,20,90,0.5\n50,20,5,-300,1e-3\n"};
}

} // namespace

std::string brokenPromise(const Measurement& measurement, std::size_t bytes)
{
    const Provenance& from = provenanceOf(measurement);
    if (from.holes > from.samples || from.negatives > from.samples || from.samples > bytes)
        return "counts that contradict each other or the file's size";
    for (const std::string& text : {from.name, from.format, from.convention})
        if (text.empty() || std::any_of(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }))
            return "a name or a convention that cannot be printed";
    const auto* const table = std::get_if<Table>(&measurement);
    if (table && table->values.size() * sizeof(double) > mostOfTable * bytes)
        return "more table than the file can hold";
    if (table)
        if (std::string broken = brokenTable(*table); !broken.empty())
            return broken;
    for (const double theta : {0.0, 0.7, 1.57})
        for (const double phi : {0.0, 2.0, 3.141592653589793})
            if (const auto f = brdfAt(measurement, directionAt(0.7, 0.3), directionAt(theta, 0.3 + phi));
                f && !isFinite(*f))
                return "a look-up that is not finite";
    return {};
}

std::vector<Reader> tableReaders()
{
    return {{"table_csv", readTable, csvSeeds()},
            {"table_json", readTable, {testing::openMaterialFile()}},
            {"merl", readTable, {testing::merlFile(2, 3, 2, {1, 2, 3}), testing::merlFile(1, 1, 1, {0, 0, 0})}},
            {"rgl", readTable, rglSeeds()},
            {"cornell", readTable, {testing::cornellFile()}},
            {"zemax", readTable, {testing::zemaxFile()}},
            {"curet", readCuretPair, {testing::curetGeometries() + std::string(halves) + testing::curetSurfaces()}}};
}

} // namespace reflectance::fuzz
