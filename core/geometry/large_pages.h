// Memory in large pages: what is filled once and soon given back costs more for its thousands of small pages than for what is
// done with it.
#pragma once

#include <cstddef>

namespace reflectance {

/// Asks the system for large pages in memory that was not touched yet. A wish: small ones serve as well.
void wantLargePages(void* memory, std::size_t bytes) noexcept;

/// reserve(), in large pages.
template <class Vector> void reserveInLargePages(Vector& vector, std::size_t count)
{
    vector.reserve(count);
    wantLargePages(vector.data(), vector.capacity() * sizeof(typename Vector::value_type));
}

/// resize(), in large pages.
template <class Vector> void resizeInLargePages(Vector& vector, std::size_t count)
{
    reserveInLargePages(vector, count);
    vector.resize(count);
}

} // namespace reflectance
