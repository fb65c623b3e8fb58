// Random numbers that are a function of a seed and a counter: whichever thread asks, and in whatever order, it gets the same.
#pragma once

#include <cstdint>

namespace reflectance {

/// Every bit of the result depends on every bit of x (the finaliser of splitmix64: Steele, Lea, Flood, Fast Splittable
/// Pseudorandom Number Generators, OOPSLA 2014).
[[nodiscard]] constexpr std::uint64_t scrambled(std::uint64_t x)
{
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

/// The numbers of one batch of one cell.
class CounterRandom {
public:
    CounterRandom(std::uint64_t seed, std::uint64_t cell, std::uint64_t batch)
        : key_(scrambled(scrambled(scrambled(seed + golden) + cell + golden) + batch + golden))
    {
    }

    /// 0 <= x < 1, in steps of 2^-53.
    [[nodiscard]] double next() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

    /// 0 <= x < count; the bias is below count / 2^64.
    [[nodiscard]] std::uint64_t below(std::uint64_t count) { return bits() % count; }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;

    [[nodiscard]] std::uint64_t bits() { return scrambled(key_ + golden * ++counter_); }

    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

} // namespace reflectance
