// CUReT (Dana et al. 1999): table.txt lists geometries (number and four angles in radians), abrdf.dat one surface a row
// (number and one BRDF value per geometry).
#include "core/base/text.h"
#include "core/measured/lines.h"
#include "core/measured/readers.h"

#include <numbers>

namespace reflectance {
namespace {

/// The numbers of a row, or a sentence.
Result<std::vector<double>> numbersIn(std::string_view line, long number, const ReadContext& context)
{
    std::vector<double> values;
    for (const std::string_view word : words(line)) {
        const auto value = parseNumber(word);
        if (!value || !(std::fabs(*value) <= largestBrdf))
            return Error{quotedPiece(word) + " is not a number, or too large", context.file, number};
        values.push_back(*value);
    }
    return values;
}

struct Geometries {
    std::vector<Vec3d> L, V;
};

Result<Geometries> readGeometries(std::string_view text, const ReadContext& context)
{
    Geometries geometries;
    Lines lines(text);
    while (const auto line = lines.next()) {
        if (trimmed(*line).empty())
            continue;
        const auto row = numbersIn(*line, lines.number(), context);
        if (!row)
            return row.error();
        const std::size_t expected = geometries.L.size() + 1;
        if (row->size() != 5 || (*row)[0] != static_cast<double>(expected))
            return Error{"a CUReT geometry is its number (here " + std::to_string(expected) + ") and four angles",
                         context.file, lines.number()};
        for (const double theta : {(*row)[1], (*row)[3]})
            if (!(theta >= 0.0 && theta <= std::numbers::pi / 2.0))
                return Error{"a polar angle is " + general(theta, 9) + " radians; 0 .. pi/2 are possible", context.file,
                             lines.number()};
        geometries.V.push_back(directionAt((*row)[1], (*row)[2]));
        geometries.L.push_back(directionAt((*row)[3], (*row)[4]));
    }
    if (geometries.L.empty())
        return Error{"lists no geometry", context.file};
    return geometries;
}

struct Surface {
    std::vector<double> values; ///< one per geometry
    std::size_t of = 0;         ///< how many there are
};

/// Surface `context.options.surface` (1-based, as the rows count).
Result<Surface> readSurface(std::string_view text, std::size_t geometries, const ReadContext& context)
{
    Surface found;
    std::size_t& rows = found.of;
    Lines lines(text);
    while (const auto line = lines.next()) {
        if (trimmed(*line).empty())
            continue;
        auto row = numbersIn(*line, lines.number(), context);
        if (!row)
            return row.error();
        if (++rows; row->size() != geometries + 1 || row->front() != static_cast<double>(rows))
            return Error{"a CUReT surface is its number (here " + std::to_string(rows) + ") and " +
                             std::to_string(geometries) + " values; this row holds " + std::to_string(row->size()) +
                             " numbers",
                         context.file, lines.number()};
        if (rows == context.options.surface)
            found.values.assign(row->begin() + 1, row->end());
    }
    if (found.values.empty())
        return Error{"holds " + std::to_string(rows) + " surfaces; there is no number " +
                         std::to_string(context.options.surface),
                     context.file};
    return found;
}

} // namespace

Result<Measurement> readCuret(std::string_view geometries, const std::string& geometriesFile, std::string_view surfaces,
                              const ReadContext& context)
{
    const auto places = readGeometries(geometries, {geometriesFile, context.options});
    if (!places)
        return places.error();
    const auto values = readSurface(surfaces, places->L.size(), context);
    if (!values)
        return values.error();
    ScatteredBrdf brdf = scatteredBrdf(places->L, places->V, values->values, 1);
    brdf.provenance.name = context.file + ", surface " + std::to_string(context.options.surface);
    brdf.provenance.surfaces = values->of;
    brdf.provenance.format = "CUReT";
    brdf.provenance.convention = "BRDF in 1/sr, mean of red, green and blue; radians";
    return Measurement(std::move(brdf));
}

} // namespace reflectance
