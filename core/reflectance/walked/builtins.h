// What a shared text may call besides its own functions: the prelude, and the common functions of GLSL.
#pragma once

#include "core/reflectance/walked/tree.h"

#include <span>

namespace reflectance::walked {

enum class Built : std::uint8_t {
    // to float
    Gate,
    Lobe,
    InsideLight,
    AngleBetween,
    Arcsine,
    ExpOrZero,
    Dot,
    Length,
    Abs,
    Floor,
    Sqrt,
    Exp,
    Exp2,
    Log,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sign,
    Pow,
    Max,
    Min,
    Clamp,
    Mix,
    Smoothstep,
    ToFloat,
    // to vec3
    GateVector,
    Mirrored,
    Halfway,
    Environment,
    TableAt,
    Cross,
    Normalize,
    MixVector,
    Grey,
    Triple,
};

struct Builtin {
    std::string_view name;
    Built built;
    Type result;
    std::span<const Type> parameters;
};

[[nodiscard]] std::span<const Builtin> builtins();

} // namespace reflectance::walked
