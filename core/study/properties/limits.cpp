// What a model turns into: `//! becomes MODEL where NAME=VALUE` in its text, held to the last bits.
#include "core/base/text.h"
#include "core/reflectance/lists.h"
#include "core/study/properties/measures.h"

#include <limits>

namespace reflectance::properties {
namespace {

/// "K=kd" with the other model's kd in place of its name.
std::string withNumbers(std::string_view assignment, const ParameterValues& ofOther)
{
    const std::size_t right = assignment.find('=') + 1; // 0 where there is none
    const auto found = ofOther.find(trimmed(assignment.substr(right)));
    if (right == 0 || found == ofOther.end())
        return std::string(assignment);
    std::vector<std::string> numbers;
    for (const double number : found->second)
        numbers.push_back(shortest(number));
    return std::string(assignment.substr(0, right)) + joined(numbers, " ");
}

/// Values of the first model that turn it into the other one at `target`: what both name, then the declared assignments,
/// and for the rest what `values` says.
Result<std::vector<double>> valuesAtLimit(const ModelText& model, const std::vector<double>& values,
                                          const ModelText& other, const std::vector<double>& target,
                                          const std::string& where)
{
    ParameterValues named = valuesByName(model, values);
    const ParameterValues ofOther = valuesByName(other, target);
    for (const auto& [name, numbers] : ofOther)
        if (model.find(name))
            named[name] = numbers;
    for (const std::string_view assignment : split(where, ';')) {
        const auto set = setParameter(model, withNumbers(assignment, ofOther), named);
        if (!set)
            return set.error();
    }
    return flatValues(model, named);
}

/// In units in the last place of the larger value; numbers below the smallest safe one count as that.
double unitsInLastPlace(const Vec3d& a, const Vec3d& b, Precision precision)
{
    const double floor = precision == Precision::Double ? 0x1p-1000 : 0x1p-100;
    const double scale = std::fmax(floor, std::fmax(largestOf(a), largestOf(b)));
    return largestOf(a - b) / (2.0 * unitRoundoff(precision) * scale);
}

void compareAt(const Model& model, const Model& other, const Place& place, const Place& target, Finding& finding)
{
    for (const Precision precision : corePrecisions) {
        Place mine = place;
        Place its = target;
        mine.precision = its.precision = precision;
        mine.directions = its.directions;
        finding.see(unitsInLastPlace(valueAt(model, mine), valueAt(other, its), precision), mine);
    }
}

void lookAtLimit(const Model& model, const DeclaredLimit& limit, const Effort& effort, Finding& finding)
{
    const auto other = findModel(limit.model);
    if (!other) {
        finding.worst = std::numeric_limits<double>::infinity();
        finding.note = other.error().sentence();
        return;
    }
    const auto own = parameterSamples(model.text, effort.parameterSets);
    std::size_t next = 0;
    everywhere(**other, effort, directionSamples(effort.directions), [&](const Place& target) {
        const auto values =
            valuesAtLimit(model.text, own[next++ % own.size()], (*other)->text, target.values, limit.where);
        if (values)
            return compareAt(model, **other, {*values, {}}, target, finding);
        finding.worst = std::numeric_limits<double>::infinity();
        finding.note = values.error().sentence();
    });
}

} // namespace

Finding measureLimits(const Model& model, const Effort& effort)
{
    Finding finding;
    finding.applies = !model.text.becomes.empty();
    std::vector<std::string> told;
    for (const DeclaredLimit& limit : model.text.becomes) {
        lookAtLimit(model, limit, effort, finding);
        told.push_back(limit.model + " where " + limit.where);
    }
    if (finding.note.empty())
        finding.note = joined(told);
    return finding;
}

} // namespace reflectance::properties
