#include "core/scene/rung_list.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {
namespace {

bool apart(const RungFacts& a, const RungFacts& b)
{
    return !(a.onCpu && b.onCpu) && !(a.onGl && b.onGl);
}

Error unknown(const std::string& id)
{
    std::vector<std::string> ids;
    for (const RungFacts& rung : rungList)
        ids.emplace_back(rung.id);
    return Error{"unknown rung '" + id + "'; did you mean '" + nearestName(id, ids) + "'?"};
}

} // namespace

const RungFacts* rungNamed(std::string_view id)
{
    const auto* const found =
        std::find_if(std::begin(rungList), std::end(rungList), [id](const RungFacts& rung) { return id == rung.id; });
    return found == std::end(rungList) ? nullptr : found;
}

Result<void> checkRungs(std::span<const std::string> rungs)
{
    std::vector<const RungFacts*> taken;
    for (const std::string& id : rungs) {
        const RungFacts* rung = rungNamed(id);
        if (rung == nullptr)
            return unknown(id);
        for (const RungFacts* other : taken) {
            const std::string both = "the rungs '" + std::string(other->id) + "' and '" + id + "'";
            if (other->axis == rung->axis)
                return Error{both + " exclude each other: both choose the " + std::string(nameOf(rung->axis)) +
                             "; leave one of them out"};
            if (apart(*other, *rung))
                return Error{both + " belong to different renderers, CPU and GL; leave one of them out"};
        }
        taken.push_back(rung);
    }
    return {};
}

bool drawnByGl(std::span<const std::string> rungs, bool otherwise)
{
    for (const std::string& id : rungs)
        if (const RungFacts* rung = rungNamed(id); rung != nullptr && rung->onCpu != rung->onGl)
            return rung->onGl;
    return otherwise;
}

std::vector<std::string> toggledRung(std::span<const std::string> rungs, const RungFacts& rung)
{
    const auto has = [&](const RungFacts& other) {
        return std::find(rungs.begin(), rungs.end(), other.id) != rungs.end();
    };
    std::vector<std::string> toggled;
    for (const RungFacts& other : rungList) {
        const bool itself = other.id == std::string_view(rung.id);
        const bool goes = !has(rung) && (other.axis == rung.axis || apart(other, rung));
        if (itself ? !has(rung) : has(other) && !goes)
            toggled.emplace_back(other.id);
    }
    return toggled;
}

} // namespace reflectance
