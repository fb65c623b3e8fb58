#include "core/geometry/weld.h"

#include "core/base/parallel.h"
#include "core/geometry/unfilled.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace reflectance {
namespace {

using Index = std::uint32_t;

/// Mixes the bits of the three coordinates (the finaliser of SplitMix64 on each).
std::uint32_t hashOf(const Vec3d& p)
{
    std::uint64_t hash = 0;
    for (const double component : {p.x, p.y, p.z}) {
        hash += std::bit_cast<std::uint64_t>(component + 0.0) + 0x9e3779b97f4a7c15ULL; // + 0.0 makes -0 a 0
        hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
        hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
        hash ^= hash >> 31;
    }
    return static_cast<std::uint32_t>(hash);
}

bool isNan(const Vec3d& v)
{
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z);
}

struct Place {
    std::uint32_t hash;
    Index index;
};

constexpr std::size_t perRange = 65536;
constexpr std::size_t perDrawer = 4096; ///< a drawer's table fits into the cache next to the processor

/// The positions by the upper bits of their hashes, in drawers: equal ones are in the same, in their order. NaN are in
/// none: many of them would only lengthen each other's search.
struct Drawers {
    UnfilledVector<Place> places;
    std::vector<std::size_t> ends; ///< of each drawer's run in `places`

    Drawers(std::span<const Vec3d> positions, int threads)
    {
        const auto drawers = std::bit_ceil(std::clamp<std::size_t>(positions.size() / perDrawer, 1, 4096));
        const auto drawerOf = [shift = 32 - std::countr_zero(drawers)](std::uint32_t hash) {
            return static_cast<std::size_t>(std::uint64_t{hash} >> shift);
        };
        const std::size_t ranges = (positions.size() + perRange - 1) / perRange;
        std::vector<std::vector<std::size_t>> next(ranges, std::vector<std::size_t>(drawers));
        inRanges(threads, positions.size(), perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                if (!isNan(positions[i]))
                    ++next[range][drawerOf(hashOf(positions[i]))];
        });
        std::size_t end = 0;
        ends.push_back(end);
        for (std::size_t drawer = 0; drawer < drawers; ++drawer) {
            for (std::vector<std::size_t>& range : next)
                end += std::exchange(range[drawer], end);
            ends.push_back(end);
        }
        places.resize(end);
        inRanges(threads, positions.size(), perRange, [&](std::size_t range, std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                if (!isNan(positions[i])) {
                    const std::uint32_t hash = hashOf(positions[i]);
                    places[next[range][drawerOf(hash)]++] = {hash, static_cast<Index>(i)};
                }
        });
    }

    [[nodiscard]] std::size_t count() const { return ends.size() - 1; }
    [[nodiscard]] std::span<const Place> of(std::size_t drawer) const
    {
        return std::span(places).subspan(ends[drawer], ends[drawer + 1] - ends[drawer]);
    }
};

/// Finds the first of equal positions in a table with open addressing.
class PlaceTable {
public:
    explicit PlaceTable(std::span<const Vec3d> positions) : positions_(positions) {}

    /// Of all positions in a drawer.
    void find(std::span<const Place> drawer, std::vector<Index>& firsts)
    {
        slots_.assign(std::bit_ceil(2 * drawer.size() + 1), {0, empty});
        for (const Place& place : drawer)
            if (const Index first = firstOf(place); first != place.index)
                firsts[place.index] = first;
    }

private:
    static constexpr Index empty = std::numeric_limits<Index>::max();

    Index firstOf(const Place& place)
    {
        std::size_t slot = place.hash & (slots_.size() - 1);
        while (slots_[slot].index != empty &&
               (slots_[slot].hash != place.hash || positions_[slots_[slot].index] != positions_[place.index]))
            slot = (slot + 1) & (slots_.size() - 1);
        if (slots_[slot].index == empty)
            slots_[slot] = place;
        return slots_[slot].index;
    }

    std::span<const Vec3d> positions_;
    std::vector<Place> slots_;
};

} // namespace

std::vector<Index> firstAtSamePlace(std::span<const Vec3d> positions, int threads)
{
    const Drawers drawers(positions, threads);
    std::vector<Index> firsts(positions.size());
    for (std::size_t i = 0; i < firsts.size(); ++i)
        firsts[i] = static_cast<Index>(i);
    constexpr std::size_t together = 16; // drawers that one table goes through
    inRanges(threads, drawers.count(), together, [&](std::size_t, std::size_t begin, std::size_t end) {
        PlaceTable table(positions);
        for (std::size_t drawer = begin; drawer < end; ++drawer)
            table.find(drawers.of(drawer), firsts);
    });
    return firsts;
}

} // namespace reflectance
