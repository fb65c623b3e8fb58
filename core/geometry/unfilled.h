// Vectors of numbers that are not set to zero before they are filled: of a large mesh that would touch every page twice,
// and on one thread.
#pragma once

#include "core/geometry/large_pages.h"

#include <memory>
#include <utility>
#include <vector>

namespace reflectance {

/// For types that begin to live without a constructor, such as numbers, arrays of them and Vec3.
template <class T> struct UnfilledAllocator : std::allocator<T> {
    template <class U> struct rebind {
        using other = UnfilledAllocator<U>;
    };

    UnfilledAllocator() = default;
    template <class U> constexpr UnfilledAllocator(const UnfilledAllocator<U>& /*unused*/) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count)
    {
        T* const memory = std::allocator<T>::allocate(count);
        wantLargePages(memory, count * sizeof(T));
        return memory;
    }

    template <class U> void construct(U* /*unused*/) noexcept {}
    template <class U, class First, class... Rest> void construct(U* place, First&& first, Rest&&... rest)
    {
        std::construct_at(place, std::forward<First>(first), std::forward<Rest>(rest)...);
    }
};

/// What resize() adds is anything until it is written.
template <class T> using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

} // namespace reflectance
