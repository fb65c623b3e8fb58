#include "core/reflectance/walked/builtins.h"

namespace reflectance::walked {
namespace {

constexpr Type f = Type::Float, v = Type::Vec3;
constexpr Type F[] = {f, f, f, f};
constexpr Type V[] = {v, v, v, v};
constexpr Type FV[] = {f, v};
constexpr Type VVF[] = {v, v, f};
constexpr Type WHOLE[] = {Type::Int};

constexpr std::span<const Type> floats(std::size_t count)
{
    return std::span(F).first(count);
}
constexpr std::span<const Type> vectors(std::size_t count)
{
    return std::span(V).first(count);
}

constexpr Builtin table[] = {
    {"gate", Built::Gate, f, floats(2)},
    {"gate", Built::GateVector, v, FV},
    {"lobe", Built::Lobe, f, VVF},
    {"insideLight", Built::InsideLight, f, vectors(2)},
    {"angleBetween", Built::AngleBetween, f, vectors(2)},
    {"arcsine", Built::Arcsine, f, floats(1)},
    {"expOrZero", Built::ExpOrZero, f, floats(1)},
    {"dot", Built::Dot, f, vectors(2)},
    {"length", Built::Length, f, vectors(1)},
    {"abs", Built::Abs, f, floats(1)},
    {"floor", Built::Floor, f, floats(1)},
    {"sqrt", Built::Sqrt, f, floats(1)},
    {"exp", Built::Exp, f, floats(1)},
    {"exp2", Built::Exp2, f, floats(1)},
    {"log", Built::Log, f, floats(1)},
    {"sin", Built::Sin, f, floats(1)},
    {"cos", Built::Cos, f, floats(1)},
    {"tan", Built::Tan, f, floats(1)},
    {"asin", Built::Asin, f, floats(1)},
    {"acos", Built::Acos, f, floats(1)},
    {"atan", Built::Atan, f, floats(1)},
    {"atan", Built::Atan2, f, floats(2)},
    {"sign", Built::Sign, f, floats(1)},
    {"pow", Built::Pow, f, floats(2)},
    {"max", Built::Max, f, floats(2)},
    {"min", Built::Min, f, floats(2)},
    {"clamp", Built::Clamp, f, floats(3)},
    {"mix", Built::Mix, f, floats(3)},
    {"mix", Built::MixVector, v, VVF},
    {"smoothstep", Built::Smoothstep, f, floats(3)},
    {"float", Built::ToFloat, f, WHOLE},
    {"mirrored", Built::Mirrored, v, vectors(2)},
    {"halfway", Built::Halfway, v, vectors(2)},
    {"environment", Built::Environment, v, vectors(1)},
    {"tableAt", Built::TableAt, v, vectors(4)},
    {"cross", Built::Cross, v, vectors(2)},
    {"normalize", Built::Normalize, v, vectors(1)},
    {"vec3", Built::Grey, v, floats(1)},
    {"vec3", Built::Triple, v, floats(3)},
};

} // namespace

std::span<const Builtin> builtins()
{
    return table;
}

} // namespace reflectance::walked
