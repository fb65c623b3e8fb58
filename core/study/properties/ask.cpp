#include "core/study/properties/ask.h"

#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "core/reflectance/lists.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace reflectance::properties {
namespace {

double degreesBetween(const Vec3d& a, const Vec3d& b)
{
    return std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

} // namespace

void Finding::see(double badness, const Place& place)
{
    if (badness <= worst)
        return;
    worst = std::isnan(badness) ? std::numeric_limits<double>::infinity() : badness;
    at = place;
}

Vec3d valueAt(const Model& model, const Place& place, const Vec3d& I)
{
    const Directions& d = place.directions;
    const Observation row{d.N, d.V, {{d.L, I, discRadius}}};
    return evaluate(model, place.values, {&row, 1}, place.precision).front();
}

double largestOf(const Vec3d& v)
{
    if (std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z))
        return std::numeric_limits<double>::infinity();
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

double smallestOf(const Vec3d& v)
{
    return std::min({v.x, v.y, v.z});
}

std::string valuesText(const ModelText& model, std::span<const double> values)
{
    if (values.size() != model.valueCount())
        return {};
    const ParameterValues byName = valuesByName(model, values);
    std::vector<std::string> texts;
    for (const Parameter& p : model.parameters) {
        std::vector<std::string> numbers;
        for (const double number : byName.find(p.name)->second)
            numbers.push_back(general(number, 4));
        texts.push_back(p.name + "=" + joined(numbers, " "));
    }
    return joined(texts, ";");
}

std::string directionsText(const Directions& d)
{
    std::vector<std::string> texts;
    if (d.L != Vec3d())
        texts.push_back("light at " + general(degreesBetween(d.N, d.L), 5) + " degrees");
    if (d.V != Vec3d())
        texts.push_back("viewer at " + general(degreesBetween(d.N, d.V), 5) + " degrees");
    if (texts.size() == 2) {
        const Vec3d across = d.L - dot(d.N, d.L) * d.N;
        texts.push_back(general(degreesBetween(across, d.V - dot(d.N, d.V) * d.N), 4) +
                        " degrees of azimuth between them");
    }
    return joined(texts);
}

} // namespace reflectance::properties
