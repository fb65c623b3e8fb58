// ASAM OpenMATERIAL 3D, BRDF look-up table (JSON): sorted rows of wavelength (m), incident zenith, exit zenith, exit
// azimuth relative to the incident one (rad; null in all rows: does not matter), and BRDF (1/sr; null: not measured).
#include "core/base/text.h"
#include "core/measured/grid_rows.h"
#include "core/measured/grid_shape.h"
#include "core/measured/lines.h"
#include "core/measured/openmaterial.h"
#include "core/measured/readers.h"
#include "core/measured/spectrum_colour.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace reflectance {
namespace {

using Json = nlohmann::json;

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

/// The member of an object; nothing where there is no object or no such member.
const Json* member(const Json& json, const char* name)
{
    if (!json.is_object())
        return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

double unrounded(double angle)
{
    for (const openmaterial::RoundedAngle& rounded : openmaterial::roundedAngles)
        if (angle == rounded.written)
            return rounded.meant;
    return angle;
}

long lineAt(std::string_view text, std::size_t byte)
{
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + std::count(text.begin(), end, '\n');
}

/// A table nests four deep. A megabyte of open brackets would take a hundred as a tree, so depth is counted before.
bool nestsTooDeep(std::string_view text)
{
    constexpr int most = 16;
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size() && depth <= most; ++i) {
        if (text[i] == '"')
            inString = !inString;
        else if (inString)
            i += text[i] == '\\' ? 1 : 0;
        else if (text[i] == '[' || text[i] == '{')
            ++depth;
        else if (text[i] == ']' || text[i] == '}')
            --depth;
    }
    return depth > most;
}

/// Whether three wavelengths stand for the colour itself.
bool isColour(const std::vector<double>& nm)
{
    return nm.size() == 3 && nm[0] >= 400.0 && nm[0] < 500.0 && nm[1] >= 500.0 && nm[1] < 580.0 && nm[2] >= 580.0 &&
           nm[2] < 700.0;
}

class OpenMaterialReader {
public:
    OpenMaterialReader(const Json& json, const ReadContext& context) : json_(json), context_(context) {}

    [[nodiscard]] Result<Measurement> read()
    {
        const Json* const brdf = member(json_, "brdf");
        const Json* const rows = brdf ? member(*brdf, "lookupTable") : nullptr;
        if (!rows || !rows->is_array())
            return fail("is no OpenMATERIAL 3D BRDF table: it has no list brdf.lookupTable");
        if (rows->empty() || !rows->front().is_array() || rows->front().size() != 5)
            return fail("its look-up table has no row of five numbers");
        isPolar_ = rows->front()[3].is_null();
        GridRows grid(isPolar_
                          ? std::vector<std::string>{"wavelength", "incident zenith", "exit zenith"}
                          : std::vector<std::string>{"wavelength", "incident zenith", "exit zenith", "exit azimuth"});
        std::size_t number = 0;
        for (const Json& row : *rows) {
            ++number;
            if (const auto problem = takeRow(row, grid))
                return fail("row " + std::to_string(number) + " of its look-up table: " + *problem);
        }
        auto axes = grid.axes();
        return axes ? assembled(*std::move(axes)) : fail(axes.error().message);
    }

private:
    [[nodiscard]] Error fail(const std::string& sentence) const { return {sentence, context_.file}; }

    [[nodiscard]] std::optional<std::string> takeRow(const Json& row, GridRows& grid)
    {
        if (!row.is_array() || row.size() != 5)
            return "it must hold five numbers";
        if (row[3].is_null() != isPolar_)
            return "its azimuth must be a number in all rows or null in all rows";
        std::vector<double> at;
        for (std::size_t i = 0; i < (isPolar_ ? 3U : 4U); ++i) {
            if (!row[i].is_number())
                return "its column " + std::to_string(i + 1) + " must be a number";
            at.push_back(i == 0 ? 1e9 * row[i].get<double>() : unrounded(row[i].get<double>()));
        }
        if (!(at[0] >= 1.0))
            return "its wavelength must be in metres, at least 1e-9";
        for (std::size_t i = 1; i < at.size(); ++i) {
            const double largest = openmaterial::roundedAngles[i == 3 ? 1 : 0].meant;
            if (!(at[i] >= 0.0 && at[i] <= largest + 1e-9))
                return "its column " + std::to_string(i + 1) + " is " + general(at[i], 9) + " radians; 0 .. " +
                       general(largest, 7) + " are possible";
        }
        if (!row[4].is_number() && !row[4].is_null())
            return "its BRDF must be a number or null";
        values_.push_back(row[4].is_null() ? hole : row[4].get<double>());
        if (const auto added = grid.add(at); !added)
            return added.error().message;
        return std::nullopt;
    }

    /// The weights with which wavelengths make channels, one grey (x) or three.
    [[nodiscard]] Result<std::vector<Vec3d>> weights(const std::vector<double>& nm, std::size_t& channels) const
    {
        const auto chosen = context_.options.wavelength;
        channels = nm.size() == 1 || chosen ? 1 : 3;
        if (nm.size() == 1 && !chosen)
            return std::vector<Vec3d>{Vec3d(1.0)};
        if (isColour(nm) && !chosen)
            return std::vector<Vec3d>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
        if (!chosen && (nm.front() > 450.0 || nm.back() < 650.0))
            return Error{"holds wavelengths from " + general(nm.front(), 6) + " to " + general(nm.back(), 6) +
                         " nm, which make no colour; choose one of them with --wavelength"};
        return weightsFor(nm, chosen);
    }

    [[nodiscard]] Result<Measurement> assembled(std::vector<std::vector<double>> axes)
    {
        const std::vector<double> nm = axes.front();
        axes.erase(axes.begin());
        Table table;
        const auto weight = weights(nm, table.channels);
        if (!weight)
            return fail(weight.error().message);
        table.system = isPolar_ ? AngleSystem::Polar : AngleSystem::Isotropic;
        table.axes = std::move(axes);
        const std::size_t samples = values_.size() / nm.size();
        for (std::size_t sample = 0; sample < samples; ++sample) {
            Vec3d sum;
            for (std::size_t k = 0; k < nm.size(); ++k) {
                const double value = values_[k * samples + sample];
                const Vec3d& w = (*weight)[k];
                // A weight of 0 must not touch the number: the colour of a hole, or the last bit of a neighbour.
                sum += Vec3d(w.x == 0.0 ? 0.0 : w.x * value, w.y == 0.0 ? 0.0 : w.y * value,
                             w.z == 0.0 ? 0.0 : w.z * value);
            }
            const double channels[3] = {sum.x, sum.y, sum.z};
            table.values.insert(table.values.end(), channels, channels + table.channels);
        }
        describeInto(table, nm);
        return finished(closedAround(std::move(table)), context_);
    }

    void describeInto(Table& table, const std::vector<double>& nm) const
    {
        Provenance& provenance = table.provenance;
        const Json* const metadata = member(json_, "metadata");
        const Json* const name = metadata ? member(*metadata, "name") : nullptr;
        provenance.name = name && name->is_string() ? printable(name->get<std::string>()) : context_.file;
        provenance.format = "OpenMATERIAL 3D";
        provenance.convention = "BRDF in 1/sr; radians; " + std::to_string(nm.size()) +
                                (nm.size() == 1 ? " wavelength, " : " wavelengths from ") + general(nm.front(), 6) +
                                " nm";
        for (std::size_t axis = 0; axis < table.axes.size(); ++axis)
            if (table.axes[axis].size() == 1)
                provenance.warnings.push_back("was measured at one angle " +
                                              std::string(angleNames(table.system)[axis]) +
                                              " only: everything else is a hole");
    }

    const Json& json_;
    const ReadContext& context_;
    bool isPolar_ = false;
    std::vector<double> values_; ///< wavelength slowest, as the rows stand
};

} // namespace

Result<Measurement> readOpenMaterial(std::string_view text, const ReadContext& context)
{
    if (nestsTooDeep(text))
        return Error{"is no OpenMATERIAL 3D BRDF table: its brackets nest deeper than one does", context.file};
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        return Error{"is not valid JSON: a comma, bracket or quote is wrong here", context.file,
                     lineAt(text, error.byte)};
    } catch (const Json::out_of_range&) {
        return Error{"holds a number that is too large; numbers up to 1e308 are possible", context.file};
    }
    return OpenMaterialReader(json, context).read();
}

} // namespace reflectance
