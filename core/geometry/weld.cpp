#include "core/geometry/weld.h"

#include <bit>
#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// Mixes the bits of the three coordinates (the finaliser of SplitMix64 on each).
std::size_t hashOf(const Vec3d& p)
{
    std::uint64_t hash = 0;
    for (const double component : {p.x, p.y, p.z}) {
        hash += std::bit_cast<std::uint64_t>(component + 0.0) + 0x9e3779b97f4a7c15ULL; // + 0.0 makes -0 a 0
        hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
        hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
        hash ^= hash >> 31;
    }
    return static_cast<std::size_t>(hash);
}

bool isNan(const Vec3d& v)
{
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z);
}

} // namespace

std::vector<std::uint32_t> firstAtSamePlace(std::span<const Vec3d> positions)
{
    constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    const std::size_t slots = std::bit_ceil(2 * positions.size() + 1);
    std::vector<std::uint32_t> table(slots, empty);
    std::vector<std::uint32_t> first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hashOf(positions[i]) & (slots - 1);
        if (isNan(positions[i])) { // many of them would only lengthen each other's search
            first[i] = i;
            continue;
        }
        while (table[slot] != empty && positions[table[slot]] != positions[i])
            slot = (slot + 1) & (slots - 1);
        if (table[slot] == empty)
            table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

} // namespace reflectance
