// Zemax BSDF: text of keyword lines, then blocks of numbers, over angles about the specular direction.
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/grid_shape.h"
#include "core/measured/lines.h"
#include "core/measured/readers.h"
#include "core/measured/spectrum_colour.h"

#include <algorithm>
#include <limits>
#include <map>

namespace reflectance {
namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view axisNames[] = {"samplerotation", "angleofincidence", "scatterazimuth", "scatterradial"};

struct Header {
    std::map<std::string, std::string, std::less<>> words; ///< "symmetry" to "planesymmetrical"
    std::vector<double> axes[4];                           ///< degrees, in the order of axisNames
};

/// Walks the lines that hold something.
class ZemaxReader {
public:
    ZemaxReader(std::string_view text, const ReadContext& context) : lines_(text), context_(context) {}

    [[nodiscard]] Result<Measurement> read()
    {
        if (const auto problem = readHeader())
            return *problem;
        if (const auto problem = checkHeader())
            return *problem;
        Table table;
        table.system = AngleSystem::Specular;
        table.channels = header_.words["spectralcontent"] == "xyz" ? 3 : 1;
        for (const std::size_t axis : {1U, 3U, 2U}) {
            table.axes.emplace_back();
            for (const double degrees : header_.axes[axis])
                table.axes.back().push_back(radians(degrees));
        }
        return readBlocks(std::move(table));
    }

private:
    [[nodiscard]] Error fail(const std::string& sentence) const { return {sentence, context_.file, lines_.number()}; }

    /// The words of the next line that is neither empty nor a comment; none at the end.
    [[nodiscard]] std::vector<std::string_view> nextWords()
    {
        while (const auto line = lines_.next())
            if (const auto found = words(line->substr(0, line->find('#'))); !found.empty())
                return found;
        return {};
    }

    [[nodiscard]] std::optional<Error> readAxis(std::vector<double>& axis, std::string_view name,
                                                std::string_view announced)
    {
        const auto count = parseInteger(announced);
        if (!count || *count < 1)
            return fail("the count of " + std::string(name) + " is " + quotedPiece(announced) +
                        "; give a whole number");
        const auto values = nextWords();
        if (values.size() != static_cast<std::size_t>(*count))
            return fail(std::string(name) + " announces " + std::to_string(*count) + " angles, but its line holds " +
                        std::to_string(values.size()));
        for (const std::string_view word : values) {
            const auto value = parseNumber(word);
            if (!value || !std::isfinite(*value))
                return fail(quotedPiece(word) + " is not an angle");
            if (!axis.empty() && *value <= axis.back())
                return fail("the angles of " + std::string(name) + " do not ascend at " + general(*value, 9));
            axis.push_back(*value);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Error> readHeader()
    {
        while (true) {
            const auto line = nextWords();
            if (line.empty())
                return fail("ends before its DataBegin; get the whole file");
            const std::string key = lowered(line[0]);
            const auto axis = std::find(std::begin(axisNames), std::end(axisNames), key);
            if (key == "databegin")
                return std::nullopt;
            if (axis != std::end(axisNames)) {
                const auto index = static_cast<std::size_t>(axis - std::begin(axisNames));
                if (!header_.axes[index].empty())
                    return fail(std::string(line[0]) + " stands here for the second time");
                if (auto problem = readAxis(header_.axes[index], line[0], line.size() > 1 ? line[1] : ""))
                    return problem;
            } else if (line.size() > 1) {
                header_.words[key] = lowered(line[1]);
            }
        }
    }

    [[nodiscard]] std::optional<Error> checkHeader()
    {
        for (std::size_t i = 0; i < 4; ++i)
            if (header_.axes[i].empty())
                return fail("has no list of angles " + std::string(axisNames[i]));
        if (const auto type = header_.words.find("scattertype"); type != header_.words.end() && type->second != "brdf")
            return fail("holds a " + quotedPiece(type->second) + "; only reflection (BRDF) can be shown");
        const std::size_t rotations = header_.axes[0].size();
        if (context_.options.surface < 1 || context_.options.surface > rotations)
            return fail("has " + std::to_string(rotations) + " sample rotations; there is no number " +
                        std::to_string(context_.options.surface));
        for (const double degrees : header_.axes[1])
            if (!(degrees >= 0.0 && degrees <= 90.0))
                return fail("an angle of incidence is " + general(degrees, 9) + " degrees; 0 .. 90 are possible");
        return std::nullopt;
    }

    [[nodiscard]] Result<Measurement> readBlocks(Table table);
    [[nodiscard]] Result<std::vector<double>> readRotations();
    void describe(Provenance& provenance) const;

    Lines lines_;
    const ReadContext& context_;
    Header header_;
};

/// The numbers of the rotation asked for: per angle of incidence, azimuth and radial angle. Every row is read and checked.
Result<std::vector<double>> ZemaxReader::readRotations()
{
    const auto& [rotations, incidences, azimuths, radials] = header_.axes;
    std::vector<double> values;
    for (std::size_t rotation = 1; rotation <= rotations.size(); ++rotation)
        for (std::size_t incidence = 0; incidence < incidences.size(); ++incidence) {
            if (const auto line = nextWords(); line.empty() || lowered(line[0]) != "tis")
                return fail("a line \"TIS number\" is missing before the block of " +
                            general(incidences[incidence], 6) + " degrees");
            for (std::size_t azimuth = 0; azimuth < azimuths.size(); ++azimuth) {
                const auto line = nextWords();
                if (line.size() != radials.size())
                    return fail("the row holds " + std::to_string(line.size()) + " numbers, but there are " +
                                std::to_string(radials.size()) + " radial angles");
                for (const std::string_view word : line) {
                    const auto value = parseNumber(word);
                    if (!value || std::isinf(*value))
                        return fail(quotedPiece(word) + " is not a number");
                    if (rotation == context_.options.surface)
                        values.push_back(*value);
                }
            }
        }
    if (const auto line = nextWords(); line.empty() || lowered(line[0]) != "dataend")
        return fail("goes on where its counts end: DataEnd is missing");
    return values;
}

Result<Measurement> ZemaxReader::readBlocks(Table table)
{
    const auto& [rotations, incidences, azimuths, radials] = header_.axes;
    std::vector<std::vector<double>> planes;
    for (std::size_t channel = 0; channel < table.channels; ++channel) {
        while (channel > 0) { // the heads of the Y and Z blocks
            const auto line = nextWords();
            if (line.empty())
                return fail("ends before its three colour blocks; get the whole file");
            if (lowered(line[0]) == "databegin")
                break;
        }
        auto plane = readRotations();
        if (!plane)
            return plane.error();
        planes.push_back(*std::move(plane));
    }
    std::size_t zeros = 0;
    for (std::size_t i = 0; i < incidences.size(); ++i)
        for (std::size_t r = 0; r < radials.size(); ++r)
            for (std::size_t a = 0; a < azimuths.size(); ++a) {
                const std::size_t at = (i * azimuths.size() + a) * radials.size() + r;
                Vec3d value;
                value.x = planes[0][at];
                if (table.channels == 3)
                    value = linearFromXyz({planes[0][at], planes[1][at], planes[2][at]});
                const bool isZero =
                    std::all_of(planes.begin(), planes.end(), [at](const auto& p) { return p[at] == 0.0; });
                const Angles angles{table.axes[0][i], table.axes[1][r], table.axes[2][a]};
                const bool isAbove = directionsAt(AngleSystem::Specular, angles).V.z > 0.0;
                zeros += isZero && isAbove ? 1 : 0;
                const Vec3d kept = isZero || !isAbove ? Vec3d(hole, hole, hole) : value;
                const double channels[3] = {kept.x, kept.y, kept.z};
                table.values.insert(table.values.end(), channels, channels + table.channels);
            }
    describe(table.provenance);
    if (zeros > 0)
        table.provenance.warnings.push_back(std::to_string(zeros) +
                                            " samples above the surface are exactly 0: taken as not measured");
    return finished(closedAround(std::move(table)), context_);
}

void ZemaxReader::describe(Provenance& provenance) const
{
    provenance.name = context_.file;
    provenance.format = "Zemax BSDF";
    provenance.convention = "BRDF in 1/sr; degrees from and about the specular direction";
    provenance.surfaces = header_.axes[0].size();
    if (provenance.surfaces > 1)
        provenance.warnings.push_back("the surface is anisotropic: this is rotation " +
                                      std::to_string(context_.options.surface) + " of " +
                                      std::to_string(header_.axes[0].size()) + ", shown as if it were isotropic");
}

} // namespace

Result<Measurement> readZemax(std::string_view text, const ReadContext& context)
{
    return ZemaxReader(text, context).read();
}

} // namespace reflectance
