#include "core/geometry/large_pages.h"

#include <cstdint>
#include <sys/mman.h>

namespace reflectance {

void wantLargePages(void* memory, std::size_t bytes) noexcept
{
    constexpr std::size_t large = 4U << 20U; // from here on some of it is whole large pages, wherever it begins
    constexpr std::uintptr_t smallPage = 4096;
    if (bytes < large)
        return;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + smallPage - 1) / smallPage * smallPage;
    static_cast<void>(::madvise(reinterpret_cast<void*>(first), begin + bytes - first, MADV_HUGEPAGE));
}

} // namespace reflectance
