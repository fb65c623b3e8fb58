#include "tests/fuzz/counted_memory.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {

std::atomic<std::size_t> held{0};
std::atomic<std::size_t> peak{0};

} // namespace

// The standard lets a program replace these; the other forms of new and delete, but the over-aligned, call them.
void* operator new(std::size_t size)
{
    void* const block = std::malloc(std::max<std::size_t>(size, 1));
    if (!block)
        throw std::bad_alloc();
    const std::size_t sum = held += ::malloc_usable_size(block);
    for (std::size_t seen = peak; seen < sum && !peak.compare_exchange_weak(seen, sum);)
        continue;
    return block;
}

void operator delete(void* block) noexcept
{
    if (block)
        held -= ::malloc_usable_size(block);
    std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
    operator delete(block);
}

namespace reflectance::fuzz {

std::size_t peakMemory()
{
    return peak;
}

std::size_t restartPeak()
{
    peak = held.load();
    return peak;
}

} // namespace reflectance::fuzz
