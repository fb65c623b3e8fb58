#include "app/cli/matrix_report.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string aligned(double value, int width, int decimals)
{
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%*.*f", width, decimals, value);
    return buffer.data();
}

std::string rowText(const Vec3d& row)
{
    return aligned(row.x, 9, 4) + aligned(row.y, 9, 4) + aligned(row.z, 9, 4);
}

const Mat3d& matrixOf(const MatrixFindings& findings, const JudgedSurface& surface)
{
    return findings.convention == Convention::Primary ? surface.M : surface.K;
}

void printSurface(std::ostream& out, const MatrixFindings& findings, const JudgedSurface& surface)
{
    const Mat3d& K = matrixOf(findings, surface);
    const Vec3d best = bestDiagonalOf(findings.system, surface, findings.convention);
    const double diagonal[] = {best.x, best.y, best.z};
    out << surface.name << '\n';
    for (std::size_t i = 0; i < 3; ++i)
        out << "   " << rowText(K.rows[i]) << "   |" << aligned(diagonal[i], 9, 4) << '\n';
}

void printPrices(std::ostream& out, const MatrixFindings& findings, const std::vector<CheatPrice>& prices,
                 std::size_t firstLight)
{
    out << "    dE2000                          mean     p95     max   max linear  negative  worst\n";
    for (const CheatPrice& price : prices) {
        std::string words(wordsFor(price.cheat));
        words.resize(28, ' ');
        out << "    " << words << aligned(price.mean, 8, 2) << aligned(price.p95, 8, 2) << aligned(price.max, 8, 2)
            << aligned(price.maxLinear, 13, 4) << aligned(static_cast<double>(price.negative), 10, 0) << "  ";
        if (price.max > 0.005)
            out << findings.surfaces[price.worstSurface].name << " under "
                << findings.lights[firstLight + price.worstLight].name;
        out << '\n';
    }
}

void printObject(std::ostream& out, const ObjectPrices& object)
{
    out << "\non the object, lights " << object.light << '\n'
        << "    dE2000                          mean     p95     max   max linear  negative pixels\n";
    for (const PicturePrice& price : object.prices) {
        std::string words(wordsFor(price.cheat));
        words.resize(28, ' ');
        out << "    " << words << aligned(price.mean, 8, 2) << aligned(price.p95, 8, 2) << aligned(price.max, 8, 2)
            << aligned(price.maxLinear, 13, 4) << aligned(static_cast<double>(price.negative), 10, 0) << '\n';
    }
}

std::size_t countInSpan(const MatrixFindings& findings)
{
    return static_cast<std::size_t>(
        std::count_if(findings.lights.begin(), findings.lights.end(), [](const JudgedLight& l) { return l.inSpan; }));
}

Json rows(const Mat3d& m)
{
    Json list = Json::array();
    for (const Vec3d& row : m.rows)
        list.push_back({row.x, row.y, row.z});
    return list;
}

Json list(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

Json described(const MatrixFindings& findings, const std::vector<CheatPrice>& prices, std::size_t firstLight)
{
    Json all = Json::array();
    for (const CheatPrice& price : prices)
        all.push_back({{"cheat", nameOf(price.cheat)},
                       {"mean", price.mean},
                       {"p95", price.p95},
                       {"max", price.max},
                       {"max_linear", price.maxLinear},
                       {"negative", price.negative},
                       {"worst_surface", findings.surfaces[price.worstSurface].name},
                       {"worst_light", findings.lights[firstLight + price.worstLight].name},
                       {"each", price.each}});
    return all;
}

Json described(const std::vector<ObjectPrices>& onObject)
{
    Json all = Json::array();
    for (const ObjectPrices& object : onObject)
        for (const PicturePrice& price : object.prices)
            all.push_back({{"light", object.light},
                           {"cheat", nameOf(price.cheat)},
                           {"mean", price.mean},
                           {"p95", price.p95},
                           {"max", price.max},
                           {"max_linear", price.maxLinear},
                           {"negative", price.negative}});
    return all;
}

} // namespace

void print(std::ostream& out, const MatrixFindings& findings)
{
    const ColorSystem& system = findings.system;
    out << "sensor " << findings.sensor << ", light " << findings.light << "; " << system.grid.size()
        << " wavelengths, " << general(system.grid.nm.front(), 4) << " .. " << general(system.grid.nm.back(), 4)
        << " nm, no integral changes by more than " << general(system.lastChange, 2) << '\n'
        << "W, what each sensor (row) sees of each primary (column) on a perfect white; condition number "
        << general(system.condition, 3) << '\n';
    for (const Vec3d& row : system.W.rows)
        out << "   " << rowText(row) << '\n';
    out << "\nK in the " << nameOf(findings.convention) << " convention ("
        << (findings.convention == Convention::Primary ? "lights are given in primaries; the specular term is ks W I"
                                                       : "lights are given as the sensor sees them on white")
        << ")   | best diagonal\n";
    for (const JudgedSurface& surface : findings.surfaces)
        printSurface(out, findings, surface);
    for (const ObjectPrices& object : findings.onObject)
        printObject(out, object);
    const std::size_t inSpan = countInSpan(findings);
    out << "\nagainst the spectral truth, " << findings.surfaces.size() << " surfaces under " << inSpan
        << " lights that the primaries can make\n";
    printPrices(out, findings, findings.inSpan, 0);
    if (findings.outside.empty())
        return;
    out << "\nand under lights that they cannot make:";
    for (std::size_t l = inSpan; l < findings.lights.size(); ++l)
        out << (l == inSpan ? " " : ", ") << findings.lights[l].name;
    out << '\n';
    printPrices(out, findings, findings.outside, inSpan);
}

Json described(const MatrixFindings& findings)
{
    const ColorSystem& system = findings.system;
    Json surfaces = Json::array();
    for (const JudgedSurface& surface : findings.surfaces)
        surfaces.push_back({{"name", surface.name},
                            {"K", rows(matrixOf(findings, surface))},
                            {"best_diagonal", list(bestDiagonalOf(system, surface, findings.convention))}});
    Json lights = Json::array();
    for (const JudgedLight& light : findings.lights)
        lights.push_back({{"name", light.name}, {"in_span", light.inSpan}, {"seen", list(light.seen)}});
    const std::size_t inSpan = countInSpan(findings);
    return {{"sensor", findings.sensor},
            {"light", findings.light},
            {"convention", nameOf(findings.convention)},
            {"W", rows(system.W)},
            {"condition", system.condition},
            {"makes_white", system.makesWhite},
            {"gain", list(system.gain)},
            {"wavelengths", system.grid.size()},
            {"last_change", system.lastChange},
            {"surfaces", surfaces},
            {"lights", lights},
            {"errors_in_span", described(findings, findings.inSpan, 0)},
            {"errors_outside", described(findings, findings.outside, inSpan)},
            {"errors_on_object", described(findings.onObject)},
            {"warnings", findings.warnings}};
}

} // namespace reflectance::cli
