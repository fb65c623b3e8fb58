// Names of their own within a list: of lights, variants, pins.
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"

#include <algorithm>
#include <string>
#include <vector>

namespace reflectance {

template <class Named> [[nodiscard]] bool nameIsTaken(const std::vector<Named>& list, const std::string& name)
{
    return std::any_of(list.begin(), list.end(), [&](const Named& one) { return one.name == name; });
}

/// The stem, or with the first number from 2 on that is free: "Hybrid", "Hybrid 2".
template <class Named> [[nodiscard]] std::string freshName(const std::vector<Named>& list, const std::string& stem)
{
    std::string name = stem;
    for (int n = 2; nameIsTaken(list, name); ++n)
        name = stem + " " + std::to_string(n);
    return name;
}

/// An error where the name is empty or another one has it; `current` stays then. `what`: "variant".
template <class Named>
[[nodiscard]] Result<void> rename(const std::vector<Named>& list, std::string& current, const std::string& name,
                                  const std::string& what)
{
    if (name == current)
        return {};
    if (trimmed(name).empty())
        return Error{"a " + what + " needs a name; type one"};
    if (nameIsTaken(list, name))
        return Error{"another " + what + " is named '" + name + "'; choose another name"};
    current = name;
    return {};
}

/// The sentence about the last one's name, which has just been read: missing, or another one's. Empty where it is good.
template <class Named> [[nodiscard]] std::string nameProblem(const std::vector<Named>& list, const std::string& what)
{
    const std::string& name = list.back().name;
    if (name.empty())
        return "a " + what + " has no name; give it one, \"name\"";
    const auto named = [&](const Named& one) { return one.name == name; };
    if (std::count_if(list.begin(), list.end(), named) > 1)
        return "two " + what + "s are named '" + name + "'; rename one of them";
    return {};
}

} // namespace reflectance
