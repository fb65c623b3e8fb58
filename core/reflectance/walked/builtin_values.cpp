#include "core/reflectance/walked/walker.h"

#include <cmath>

namespace reflectance::walked {

template <class T> T Walker<T>::builtNumber(const Node& node)
{
    const auto& of = node.arguments;
    switch (builtins()[node.slot].built) {
    case Built::Lobe: {
        const Vec3<T> R = vector(of[0]), V = vector(of[1]);
        return lobe(R, V, number(of[2]));
    }
    case Built::InsideLight: {
        const Vec3<T> R = vector(of[0]);
        return this->insideLight(R, vector(of[1]));
    }
    case Built::AngleBetween: {
        const Vec3<T> A = vector(of[0]);
        return angleBetween(A, vector(of[1]));
    }
    case Built::Dot: {
        const Vec3<T> a = vector(of[0]);
        return dot(a, vector(of[1]));
    }
    case Built::Length: {
        const Vec3<T> a = vector(of[0]);
        return sqrt(dot(a, a));
    }
    case Built::ToFloat:
        return static_cast<T>(whole(of[0]));
    default:
        return builtNumberOfNumbers(node);
    }
}

template <class T> T Walker<T>::builtNumberOfNumbers(const Node& node)
{
    const auto& of = node.arguments;
    const T a = number(of[0]);
    const T b = of.size() > 1 ? number(of[1]) : T(0);
    const T c = of.size() > 2 ? number(of[2]) : T(0);
    switch (builtins()[node.slot].built) {
    case Built::Gate:
        return gate(a, b);
    case Built::Arcsine:
        return arcsine(a);
    case Built::ExpOrZero:
        return expOrZero(a);
    case Built::Abs:
        return abs(a);
    case Built::Floor:
        return floor(a);
    case Built::Sqrt:
        return sqrt(a);
    case Built::Exp:
        return std::exp(a);
    case Built::Exp2:
        return exp2(a);
    case Built::Log:
        return std::log(a);
    case Built::Sin:
        return std::sin(a);
    case Built::Cos:
        return std::cos(a);
    case Built::Tan:
        return std::tan(a);
    case Built::Asin:
        return std::asin(a);
    case Built::Acos:
        return std::acos(a);
    case Built::Atan:
        return std::atan(a);
    case Built::Atan2:
        return std::atan2(a, b);
    case Built::Sign:
        return a > T(0) ? T(1) : a < T(0) ? T(-1) : T(0);
    case Built::Pow:
        return pow(a, b);
    case Built::Max:
        return max(a, b);
    case Built::Min:
        return min(a, b);
    case Built::Clamp:
        return clamp(a, b, c);
    case Built::Mix:
        return mix(a, b, c);
    default:
        return smoothstep(a, b, c);
    }
}

template <class T> Vec3<T> Walker<T>::builtVector(const Node& node)
{
    const auto& of = node.arguments;
    switch (builtins()[node.slot].built) {
    case Built::GateVector: {
        const T condition = number(of[0]);
        return gate(condition, vector(of[1]));
    }
    case Built::Grey:
        return Vec3<T>(number(of[0]));
    case Built::Triple: {
        const T x = number(of[0]), y = number(of[1]);
        return {x, y, number(of[2])};
    }
    case Built::Environment:
        return this->environment(vector(of[0]));
    case Built::Normalize: {
        const Vec3<T> a = vector(of[0]);
        return a / sqrt(dot(a, a));
    }
    default:
        break;
    }
    const Vec3<T> a = vector(of[0]), b = vector(of[1]);
    switch (builtins()[node.slot].built) {
    case Built::Mirrored:
        return mirrored(a, b);
    case Built::Halfway:
        return halfway(a, b);
    case Built::Cross:
        return cross(a, b);
    case Built::MixVector:
        return mix(a, b, number(of[2]));
    default: {
        const Vec3<T> V = vector(of[2]);
        return this->tableAt(a, b, V, vector(of[3]));
    }
    }
}

template class Walker<double>;
template class Walker<float>;

} // namespace reflectance::walked
