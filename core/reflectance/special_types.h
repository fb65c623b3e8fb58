// The types that stand for K and ks in a model's special forms, and what they do to a vector. Included by the kernels only.
#pragma once

#include "core/math/vec.h"
#include "core/reflectance/special_form.h"

#include <type_traits>

namespace reflectance {

template <class T> struct DiagonalMatrix {
    Vec3<T> diagonal;

    friend constexpr Vec3<T> operator*(const DiagonalMatrix& m, const Vec3<T>& v) { return m.diagonal * v; }
};

template <class T> struct GreyMatrix {
    T factor;

    friend constexpr Vec3<T> operator*(const GreyMatrix& m, const Vec3<T>& v) { return m.factor * v; }
};

/// A term that is 0, and what it multiplies.
struct Nothing {
    template <class T> friend constexpr Nothing operator*(Nothing, const Vec3<T>&) { return {}; }
    template <class T> friend constexpr Nothing operator*(const T&, Nothing) { return {}; }
    template <class T> friend constexpr Vec3<T> operator+(Nothing, const Vec3<T>& v) { return v; }
};

template <class T, MatrixForm form>
using MatrixOf =
    std::conditional_t<form == MatrixForm::Full, Mat3<T>,
                       std::conditional_t<form == MatrixForm::Diagonal, DiagonalMatrix<T>,
                                          std::conditional_t<form == MatrixForm::Grey, GreyMatrix<T>, Nothing>>>;

template <class T, ColorForm form> using ColorOf = std::conditional_t<form == ColorForm::Three, Vec3<T>, T>;

/// K from nine numbers, row by row.
template <class T, class M> [[nodiscard]] M matrixFrom(const double* nine)
{
    const auto at = [nine](std::size_t i) { return lit<T>(nine[i]); };
    if constexpr (std::is_same_v<M, Mat3<T>>)
        return {{{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}}};
    else if constexpr (std::is_same_v<M, DiagonalMatrix<T>>)
        return {{at(0), at(4), at(8)}};
    else if constexpr (std::is_same_v<M, GreyMatrix<T>>)
        return {at(0)};
    else
        return {};
}

/// ks from three numbers.
template <class T, class C> [[nodiscard]] C colorFrom(const double* three)
{
    if constexpr (std::is_same_v<C, T>)
        return lit<T>(three[0]);
    else
        return {lit<T>(three[0]), lit<T>(three[1]), lit<T>(three[2])};
}

/// A model that is black for viewers behind its surface.
template <class Model, class T> struct Facing : Model {
    using Model::Model;

    [[nodiscard]] Vec3<T> shade(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I)
    {
        return gate(dot(N, V), Model::shade(N, L, V, I));
    }
};

template <class Model, class T, bool facing> using FacingIf = std::conditional_t<facing, Facing<Model, T>, Model>;

} // namespace reflectance
