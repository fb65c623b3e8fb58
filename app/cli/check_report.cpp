// The figures of `check` as JSON.
#include "app/cli/check_report.h"

#include "core/base/text.h"
#include "core/study/properties/matrix_facts.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(general(value, 6)); // JSON knows no infinity
}

Json list(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

} // namespace

std::string placeText(const ModelText& model, const properties::Place& place)
{
    std::vector<std::string> parts{properties::directionsText(place.directions)};
    if (!place.values.empty())
        parts.insert(parts.begin(), properties::valuesText(model, place.values));
    return joined(parts, ", ") + " (" + std::string(nameOf(place.precision)) + ")";
}

Json described(const ModelText& model, const properties::PropertyResult& result)
{
    const properties::Finding& finding = result.finding;
    Json where = nullptr;
    if (!finding.at.values.empty())
        where = {{"text", placeText(model, finding.at)}, {"precision", nameOf(finding.at.precision)},
                 {"values", finding.at.values},          {"N", list(finding.at.directions.N)},
                 {"L", list(finding.at.directions.L)},   {"V", list(finding.at.directions.V)}};
    return {{"property", result.property.name},
            {"asks", result.property.asks},
            {"method", result.property.method},
            {"verdict", nameOf(result.verdict)},
            {"holds", result.holds},
            {"worst", number(finding.worst)},
            {"allowed", result.property.allowed},
            {"allowance", result.property.allowance},
            {"declared", result.declared},
            {"note", finding.note},
            {"where", where}};
}

Json matrixReport(const Parameter& matrix)
{
    const properties::MatrixFacts facts = properties::matrixFacts(matrix.initial);
    Json eigenvalues = Json::array();
    for (const auto& z : facts.eigenvalues)
        eigenvalues.push_back({z.real(), z.imag()});
    return {{"parameter", matrix.name},
            {"row_sums", facts.rowSums},
            {"eigenvalues", eigenvalues},
            {"spectral_radius", facts.spectralRadius},
            {"negative_entries", facts.negativeEntries},
            {"passive", facts.passive}};
}

} // namespace reflectance::cli
