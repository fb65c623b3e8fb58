// The hybrid written by hand for AVX2, as fast code does it elsewhere: log2 and exp2 as polynomials, the power of the bare dot
// product, no care for its rounding. A yardstick of speed alone: how much the shipped kernel pays for accuracy.
#include "tests/benchmarks/yardstick.h"

#include <immintrin.h>
#include <initializer_list>

namespace reflectance {
namespace {

struct Three {
    __m256 x, y, z;
};

Three load(const Vec3Array<const float>& from, std::size_t i)
{
    return {_mm256_loadu_ps(from.x + i), _mm256_loadu_ps(from.y + i), _mm256_loadu_ps(from.z + i)};
}

__m256 product(const Three& a, const Three& b)
{
    return _mm256_fmadd_ps(a.x, b.x, _mm256_fmadd_ps(a.y, b.y, _mm256_mul_ps(a.z, b.z)));
}

/// log2(1 + t) by Chebyshev points, t in 0 .. 1: 4e-6.
__m256 log2Of(__m256 x)
{
    const __m256i bits = _mm256_castps_si256(x);
    const __m256 exponent = _mm256_cvtepi32_ps(_mm256_sub_epi32(_mm256_srli_epi32(bits, 23), _mm256_set1_epi32(127)));
    const __m256i mantissa =
        _mm256_or_si256(_mm256_and_si256(bits, _mm256_set1_epi32(0x007FFFFF)), _mm256_set1_epi32(0x3F800000));
    const __m256 m = _mm256_castsi256_ps(mantissa);
    const __m256 one = _mm256_set1_ps(1.0F);
    const __m256 s = _mm256_div_ps(_mm256_sub_ps(m, one), _mm256_add_ps(m, one)); // 0 .. 1/3
    const __m256 t = _mm256_mul_ps(s, s);
    __m256 sum = _mm256_set1_ps(2.0F / 7.0F);
    for (const float c : {2.0F / 5.0F, 2.0F / 3.0F, 2.0F})
        sum = _mm256_fmadd_ps(sum, t, _mm256_set1_ps(c));
    return _mm256_fmadd_ps(_mm256_mul_ps(sum, s), _mm256_set1_ps(1.44269504F), exponent);
}

/// 0 below 2^-120: a highlight's tail of subnormal numbers would double the time of the whole kernel.
__m256 exp2Of(__m256 y)
{
    const __m256 kept = _mm256_cmp_ps(y, _mm256_set1_ps(-120.0F), _CMP_GE_OQ);
    y = _mm256_max_ps(y, _mm256_set1_ps(-120.0F));
    const __m256 whole = _mm256_round_ps(y, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    const __m256 r = _mm256_sub_ps(y, whole);
    __m256 sum = _mm256_set1_ps(1.3333558e-3F);
    for (const float c : {9.6181291e-3F, 5.5504109e-2F, 0.24022651F, 0.69314718F, 1.0F})
        sum = _mm256_fmadd_ps(sum, r, _mm256_set1_ps(c));
    const __m256i shift = _mm256_slli_epi32(_mm256_cvtps_epi32(whole), 23);
    return _mm256_and_ps(_mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(sum), shift)), kept);
}

void add(float* to, __m256 value)
{
    _mm256_storeu_ps(to, _mm256_add_ps(_mm256_loadu_ps(to), value));
}

} // namespace

void yardstickHybrid(const double* values, const ShadeBatch<float>& batch)
{
    __m256 K[9];
    for (int k = 0; k < 9; ++k)
        K[k] = _mm256_set1_ps(static_cast<float>(values[k]));
    const __m256 ks = _mm256_set1_ps(static_cast<float>(values[9]));
    const __m256 n = _mm256_set1_ps(static_cast<float>(values[12]));
    const __m256 zero = _mm256_setzero_ps();
    for (std::size_t i = 0; i + 8 <= batch.count; i += 8) {
        const Three N = load(batch.N, i);
        const Three L = load(batch.L, i);
        const Three V = load(batch.V, i);
        const Three I = load(batch.I, i);
        const __m256 cosine = product(N, L);
        const __m256 twice = _mm256_add_ps(cosine, cosine);
        // R.V = 2 (N.L)(N.V) - L.V
        const __m256 reflected = _mm256_fmsub_ps(twice, product(N, V), product(L, V));
        const __m256 power = exp2Of(_mm256_mul_ps(n, log2Of(_mm256_max_ps(reflected, _mm256_set1_ps(1e-30F)))));
        const __m256 lobe = _mm256_and_ps(_mm256_mul_ps(ks, power), _mm256_cmp_ps(reflected, zero, _CMP_GT_OQ));
        const __m256 open = _mm256_cmp_ps(cosine, zero, _CMP_GT_OQ);
        const auto channel = [&](int row, __m256 light) {
            const __m256 matte = product({K[3 * row], K[3 * row + 1], K[3 * row + 2]}, I);
            return _mm256_and_ps(_mm256_fmadd_ps(cosine, matte, _mm256_mul_ps(lobe, light)), open);
        };
        add(batch.sum.x + i, channel(0, I.x));
        add(batch.sum.y + i, channel(1, I.y));
        add(batch.sum.z + i, channel(2, I.z));
    }
}

} // namespace reflectance
