// The lobe as every model has it unless another form is asked for; its C++ twin is core/math/lobe.h.

// log((1+s)/(1-s)) = 2 (s + s^3/3 + s^5/5 + ...) for |s| <= 1/3; the first term left out is below 2^-28 of the result.
float logOfQuotient(float s)
{
    float t = s * s;
    float tail = t * (1.0 / 3.0 + t * (1.0 / 5.0 + t * (1.0 / 7.0 + t * (1.0 / 9.0 +
                 t * (1.0 / 11.0 + t * (1.0 / 13.0 + t * (1.0 / 15.0)))))));
    return 2.0 * (s + s * tail);
}

// log(1-x) for 0 <= x <= 1/2, without ever forming 1-x: GLSL has no log1p.
float logOneMinus(float x) { return -logOfQuotient(x / (2.0 - x)); }

// log(c) for normal c > 0: c = 2^e m with m in [2/3, 4/3).
float logOf(float c)
{
    int bits = floatBitsToInt(c);
    int e = ((bits - 0x3F2AAAAB) >> 23);
    float m = intBitsToFloat(bits - (e << 23));
    return logOfQuotient((m - 1.0) / (m + 1.0)) + float(e) * 0.69314718;
}

// (R.V)^n in its conditioned form: exp(n log(1-x)) with x = |R-V|^2 / 2 = 1 - R.V where R.V > 1/2, the plain dot below.
// 0 wherever R.V <= 0, at every n, n = 0 included.
float lobe(vec3 R, vec3 V, float n)
{
    float cosine = dot(R, V);
    if (!(cosine > 0.0))
        return 0.0;
    vec3 chord = R - V;
    float logarithm = cosine > 0.5 ? logOneMinus(0.5 * dot(chord, chord)) : logOf(cosine);
    return expOrZero(n * logarithm);
}
