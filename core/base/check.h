// CHECK is for what only the programmer can cause. It prints both operands and stops the program.
#pragma once

#include <cstdlib>
#include <iostream>

namespace reflectance::detail {

template <class A, class B>
[[noreturn]] void checkFailed(const char* text, const A& a, const B& b, const char* file, int line)
{
    std::cerr << file << ':' << line << ": CHECK(" << text << ") failed: " << a << " against " << b << '\n';
    std::abort();
}

} // namespace reflectance::detail

#define REFLECTANCE_CHECK_OP(a, op, b)                                                                                 \
    do {                                                                                                               \
        if (!((a)op(b)))                                                                                               \
            ::reflectance::detail::checkFailed(#a " " #op " " #b, (a), (b), __FILE__, __LINE__);                       \
    } while (false)
#define CHECK_EQ(a, b) REFLECTANCE_CHECK_OP(a, ==, b)
#define CHECK_LT(a, b) REFLECTANCE_CHECK_OP(a, <, b)
#define CHECK_LE(a, b) REFLECTANCE_CHECK_OP(a, <=, b)
