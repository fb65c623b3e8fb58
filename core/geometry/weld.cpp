#include "core/geometry/weld.h"

#include <algorithm>
#include <array>
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

/// Finds the first of equal positions in a table with open addressing.
class PlaceTable {
public:
    explicit PlaceTable(std::span<const Vec3d> positions)
        : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), empty)
    {
    }

    /// Where the search for a position begins; to be asked for well before, so that it is there when it is needed.
    std::size_t beginFor(const Vec3d& position)
    {
        const std::size_t slot = hashOf(position) & (slots_.size() - 1);
        __builtin_prefetch(&slots_[slot], 1);
        return slot;
    }

    std::uint32_t first(std::uint32_t i, std::size_t slot)
    {
        if (isNan(positions_[i])) // many of them would only lengthen each other's search
            return i;
        while (slots_[slot] != empty && positions_[slots_[slot]] != positions_[i])
            slot = (slot + 1) & (slots_.size() - 1);
        if (slots_[slot] == empty)
            slots_[slot] = i;
        return slots_[slot];
    }

private:
    static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

    std::span<const Vec3d> positions_;
    std::vector<std::uint32_t> slots_;
};

} // namespace

std::vector<std::uint32_t> firstAtSamePlace(std::span<const Vec3d> positions)
{
    PlaceTable table(positions);
    std::vector<std::uint32_t> result(positions.size());
    std::array<std::size_t, 32> slots;
    for (std::size_t begin = 0; begin < positions.size(); begin += slots.size()) {
        const std::size_t count = std::min(slots.size(), positions.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            slots[i] = table.beginFor(positions[begin + i]);
        for (std::size_t i = 0; i < count; ++i)
            result[begin + i] = table.first(static_cast<std::uint32_t>(begin + i), slots[i]);
    }
    return result;
}

} // namespace reflectance
