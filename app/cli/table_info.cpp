#include "app/cli/table_info.h"

#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/facts.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

double degrees(double angle)
{
    return angle * 180.0 / std::numbers::pi;
}

/// Everything that `info` reports, measured once.
struct Findings {
    const Measurement& measurement;
    std::vector<Albedo> albedos;
    std::vector<Reciprocity> reciprocity;
    std::vector<LeftOut> leftOut;
    std::string inRenderers; ///< the sentence about the grid that the renderers get; empty: the table itself
};

Findings findingsOf(const Measurement& measurement)
{
    Findings findings{measurement, {}, {}, leaveOneOut(measurement), {}};
    for (const double limit : {60.0, 85.0}) // measurements become unsure at grazing angles
        findings.reciprocity.push_back(reciprocityOf(measurement, radians(limit)));
    for (const double thetaI : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0})
        findings.albedos.push_back(albedoAt(measurement, radians(thetaI)));
    const Table grid = gridOf(measurement);
    if (grid.provenance.warnings.size() > provenanceOf(measurement).warnings.size())
        findings.inRenderers = grid.provenance.warnings.back();
    return findings;
}

std::string percent(double share)
{
    return general(100.0 * share, 3) + " %";
}

void printAngles(const Measurement& measurement)
{
    const auto* const table = std::get_if<Table>(&measurement);
    if (!table)
        return;
    std::cout << "  angles       " << shapeText(*table) << "; interpolation " << nameOf(table->interpolation) << '\n';
    for (std::size_t axis = 0; axis < table->axes.size(); ++axis) {
        const auto& at = table->axes[axis];
        std::cout << "               " << angleNames(table->system)[axis] << "  " << general(degrees(at.front()), 5)
                  << " .. " << general(degrees(at.back()), 5) << " degrees\n";
    }
}

void print(const Findings& findings)
{
    const Provenance& from = provenanceOf(findings.measurement);
    const std::size_t channels = channelsOf(findings.measurement);
    std::cout << from.name << "\n  format       " << from.format << "\n  holds        " << from.convention << '\n';
    printAngles(findings.measurement);
    std::cout << "  channels     "
              << (channels == 1   ? "1, grey"
                  : channels == 3 ? "3, linear sRGB"
                                  : "9, a matrix row by row")
              << "\n  samples      " << from.samples << ", of them " << from.holes << " holes and " << from.negatives
              << " negative\n";
    for (const Albedo& albedo : findings.albedos) {
        std::cout << "  albedo       " << general(degrees(albedo.thetaI), 3) << " degrees: ";
        if (albedo.known == 0.0) {
            std::cout << "not measured\n";
            continue;
        }
        std::cout << general(albedo.value.x, 5);
        if (channels > 1)
            std::cout << ' ' << general(albedo.value.y, 5) << ' ' << general(albedo.value.z, 5);
        std::cout << (albedo.known < 1.0 ? " from the " + percent(albedo.known) + " that are known" : "") << '\n';
    }
    for (const Reciprocity& r : findings.reciprocity)
        std::cout << "  reciprocity  " << percent(r.rms) << " rms, " << percent(r.worst)
                  << " of the peak at worst, up to " << general(degrees(r.limit), 3) << " degrees (" << r.compared
                  << " pairs)\n";
    for (const LeftOut& left : findings.leftOut)
        std::cout << "  left out     along " << left.along << ": told from its neighbours to " << percent(left.rms)
                  << " rms, " << percent(left.worst) << " of the peak at worst (" << left.told << " samples)\n";
    for (const std::string& warning : from.warnings)
        std::cout << "  warning      " << warning << '\n';
    if (!findings.inRenderers.empty())
        std::cout << "  renderers    " << findings.inRenderers << '\n';
}

Json anglesReport(const Measurement& measurement)
{
    Json angles = Json::array();
    if (const auto* const table = std::get_if<Table>(&measurement))
        for (std::size_t axis = 0; axis < table->axes.size(); ++axis) {
            Json values = Json::array();
            for (const double angle : table->axes[axis])
                values.push_back(degrees(angle));
            angles.push_back({{"name", angleNames(table->system)[axis]}, {"degrees", values}});
        }
    return angles;
}

Json report(const Findings& findings)
{
    const Provenance& from = provenanceOf(findings.measurement);
    Json albedos = Json::array();
    for (const Albedo& albedo : findings.albedos)
        albedos.push_back({{"theta_i", degrees(albedo.thetaI)},
                           {"value", {albedo.value.x, albedo.value.y, albedo.value.z}},
                           {"known", albedo.known},
                           {"uncertainty", albedo.uncertainty}});
    Json reciprocities = Json::array();
    for (const Reciprocity& r : findings.reciprocity)
        reciprocities.push_back(
            {{"up_to_theta", degrees(r.limit)}, {"rms", r.rms}, {"worst", r.worst}, {"pairs", r.compared}});
    Json leftOut = Json::array();
    for (const LeftOut& left : findings.leftOut)
        leftOut.push_back({{"along", left.along}, {"rms", left.rms}, {"worst", left.worst}, {"samples", left.told}});
    Json result{{"name", from.name},
                {"format", from.format},
                {"convention", from.convention},
                {"channels", channelsOf(findings.measurement)},
                {"samples", from.samples},
                {"holes", from.holes},
                {"negatives", from.negatives},
                {"angles", anglesReport(findings.measurement)},
                {"albedo", albedos},
                {"reciprocity", reciprocities},
                {"left_out", leftOut},
                {"warnings", from.warnings}};
    if (const auto* const table = std::get_if<Table>(&findings.measurement)) {
        result["grid"] = nameOf(table->system);
        result["interpolation"] = nameOf(table->interpolation);
    }
    if (!findings.inRenderers.empty())
        result["in_renderers"] = findings.inRenderers;
    return result;
}

/// theta_i down, theta_r across, degrees; the residual in 1/sr, nan where one direction was not measured.
std::string mapText(const ReciprocityMap& map)
{
    std::string text = "theta_i_deg,theta_r_deg,residual\n";
    for (std::size_t i = 0; i < map.theta.size(); ++i)
        for (std::size_t r = 0; r < map.theta.size(); ++r) {
            const double residual = map.residual[i * map.theta.size() + r];
            text += general(degrees(map.theta[i]), 12) + ',' + general(degrees(map.theta[r]), 12) + ',' +
                    (std::isnan(residual) ? "nan" : shortest(residual)) + '\n';
        }
    return text;
}

} // namespace

int runInfo(const InfoOptions& options)
{
    const auto measurement = measurementFrom(options.source);
    if (!measurement)
        return refused(measurement.error());
    const Findings findings = findingsOf(*measurement);
    if (options.json != "-")
        print(findings);
    if (!options.map.empty()) {
        const ReciprocityMap map = reciprocityMap(*measurement, radians(options.azimuth), 90);
        if (const auto written = writeAtomically(options.map, mapText(map)); !written)
            return refused(written.error());
    }
    const auto written = writeReport(options.json, report(findings));
    return written ? Done : refused(written.error());
}

} // namespace reflectance::cli
