// What exponentials.h asks of a number type: its layout, and choices without a branch. SIMD lanes have theirs in lanes.h.
#pragma once

#include <bit>
#include <cstdint>

namespace reflectance {

/// IEEE 754: the whole number of the same width, the bits of the mantissa, and what is added to the exponent.
template <class S> struct NumberBits;

template <> struct NumberBits<double> {
    using Bits = std::uint64_t;
    static constexpr int mantissa = 52;
    static constexpr int bias = 1023;
};

template <> struct NumberBits<float> {
    using Bits = std::uint32_t;
    static constexpr int mantissa = 23;
    static constexpr int bias = 127;
};

[[nodiscard]] inline std::uint64_t bitsOf(double x)
{
    return std::bit_cast<std::uint64_t>(x);
}
[[nodiscard]] inline std::uint32_t bitsOf(float x)
{
    return std::bit_cast<std::uint32_t>(x);
}
[[nodiscard]] inline double fromBits(std::uint64_t bits)
{
    return std::bit_cast<double>(bits);
}
[[nodiscard]] inline float fromBits(std::uint32_t bits)
{
    return std::bit_cast<float>(bits);
}

[[nodiscard]] inline double choose(bool first, double a, double b)
{
    return first ? a : b;
}
[[nodiscard]] inline float choose(bool first, float a, float b)
{
    return first ? a : b;
}
/// a or 0.
[[nodiscard]] inline double choose(bool open, double a)
{
    return open ? a : 0.0;
}
[[nodiscard]] inline float choose(bool open, float a)
{
    return open ? a : 0.0F;
}
[[nodiscard]] inline double multiplyAdd(double a, double b, double c)
{
    return a * b + c;
}
[[nodiscard]] inline float multiplyAdd(float a, float b, float c)
{
    return a * b + c;
}
[[nodiscard]] inline double multiplySubtract(double a, double b, double c)
{
    return a * b - c;
}
[[nodiscard]] inline float multiplySubtract(float a, float b, float c)
{
    return a * b - c;
}

} // namespace reflectance
