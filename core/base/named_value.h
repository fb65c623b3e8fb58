// One word of a choice, as files and flags spell it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

template <class T> struct NamedValue {
    std::string_view name;
    T value;
};

template <class T, std::size_t count> [[nodiscard]] std::string nameOf(const NamedValue<T> (&names)[count], T value)
{
    for (const NamedValue<T>& named : names)
        if (named.value == value)
            return std::string(named.name);
    return {};
}

template <class T, std::size_t count>
[[nodiscard]] std::vector<std::string> namesIn(const NamedValue<T> (&names)[count])
{
    std::vector<std::string> all;
    for (const NamedValue<T>& named : names)
        all.emplace_back(named.name);
    return all;
}

} // namespace reflectance
