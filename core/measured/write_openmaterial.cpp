// Written by hand rather than through a JSON tree: a table of a million rows would take gigabytes there.
#include "core/base/check.h"
#include "core/base/text.h"
#include "core/measured/lines.h"
#include "core/measured/openmaterial.h"
#include "core/measured/write.h"

namespace reflectance {
namespace {

/// The standard's limits are rounded down, and a validator refuses what lies above them.
double rounded(double angle)
{
    for (const openmaterial::RoundedAngle& rounded : openmaterial::roundedAngles)
        if (angle == rounded.meant)
            return rounded.written;
    return angle;
}

std::string inQuotes(const std::string& name)
{
    std::string text = "\"";
    for (const char c : printable(name))
        text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return text + "\"";
}

/// What the schema asks for; a nil UUID says that none was given.
std::string metadata(const Table& table)
{
    return "{\n  \"metadata\": {\n    \"name\": " + inQuotes(table.provenance.name) +
           ",\n    \"uuid\": \"00000000-0000-0000-0000-000000000000\",\n    \"materialVersion\": \"1.0.0\",\n"
           "    \"openMaterial3dVersion\": \"1.1.0\",\n    \"copyrights\": [\"not stated\"],\n"
           "    \"license\": \"not stated\",\n    \"authors\": [\"not stated\"],\n    \"sources\": " +
           inQuotes(table.provenance.format.empty() ? "simulated" : table.provenance.format) +
           ",\n    \"typicalSensorTechnology\": \"camera\"\n  },\n";
}

} // namespace

std::string openMaterialText(const Table& table)
{
    CHECK_LE(table.channels, std::size_t{3});
    const bool isPolar = table.system == AngleSystem::Polar;
    CHECK_EQ(isPolar || table.system == AngleSystem::Isotropic, true);
    // Metres, ascending as the standard sorts them; a grey has no wavelength of its own and takes the green one.
    const std::vector<std::string> metres =
        table.channels == 1
            ? std::vector<std::string>{general(1e-9 * openmaterial::green, 6)}
            : std::vector<std::string>{general(1e-9 * openmaterial::blue, 6), general(1e-9 * openmaterial::green, 6),
                                       general(1e-9 * openmaterial::red, 6)};
    std::string text =
        metadata(table) + "  \"brdf\": {\n    \"wavelengths\": [" + joined(metres) + "],\n    \"lookupTable\": [";
    const std::vector<double> one{0.0};
    for (std::size_t k = 0; k < metres.size(); ++k) {
        std::size_t at = metres.size() - 1 - k; // blue first
        for (const double thetaI : table.axes[0])
            for (const double thetaR : table.axes[1])
                for (const double phi : isPolar ? one : table.axes[2]) {
                    const double value = table.values[at];
                    text.append(text.back() == '[' ? "\n" : ",\n").append("      [").append(metres[k]);
                    text.append(", ").append(shortest(rounded(thetaI))).append(", ").append(shortest(rounded(thetaR)));
                    text.append(", ").append(isPolar ? "null" : shortest(rounded(phi)));
                    text.append(", ").append(std::isnan(value) ? "null" : shortest(value)).append("]");
                    at += table.channels;
                }
    }
    return text + "\n    ]\n  }\n}\n";
}

} // namespace reflectance
