//! name      Koenderink
//! family    From measurements
//! formula   sum a S(r_i, r_v) cos(l(phi_i - phi_v)) I (N.L) / 2
//! citation  Koenderink, van Doorn, Stavridi, Bidirectional Reflection Distribution Function Expressed in Terms of Surface Scattering Modes, ECCV 1996
//! about     Any isotropic surface, written as a sum of smooth scattering modes: Zernike polynomials of the disc r = sqrt(2) sin(theta/2), one for the light and one for the viewer, made reciprocal. 5 numbers give its broad behaviour, 55 also its finer one. It knows nothing of facets: coefficients come from fits to measurements, and a sum cut off ripples, so values may be negative.
//! reciprocal yes
//! passive   no: coefficients may be any numbers
//! nonnegative no: coefficients may be, and a sum that is cut off ripples

uniform int order = 2;
//: label    Order
//: symbol   N
//: choices  2 8
//: tooltip  The largest degree of the polynomials: order 2 takes 5 coefficients, order 8 takes 55.
//: source   Koenderink et al. 1996; the orders of the CUReT data base

uniform float coefficients[55] = float[](1.3, 0.15, 0.1, 0.35, 0.15);
//: label    Coefficients
//: symbol   a
//: slider   -2 .. 2
//: legal    -inf .. inf
//: tooltip  Strength of each mode, named by its azimuthal order l and the degrees n and m of its two polynomials. l0_n0_m0 alone is a Lambert surface of albedo a/2.
//: source   Koenderink et al. 1996; the basis is orthonormal over pairs of directions
//: names    order=2 l0_n0_m0 l0_n2_m0 l0_n2_m2 l1_n1_m1 l2_n2_m2
//: names    order=8 l0_n0_m0 l0_n2_m0 l0_n2_m2 l0_n4_m0 l0_n4_m2 l0_n4_m4 l0_n6_m0 l0_n6_m2 l0_n6_m4 l0_n6_m6
//: names    order=8 l0_n8_m0 l0_n8_m2 l0_n8_m4 l0_n8_m6 l0_n8_m8
//: names    order=8 l1_n1_m1 l1_n3_m1 l1_n3_m3 l1_n5_m1 l1_n5_m3 l1_n5_m5 l1_n7_m1 l1_n7_m3 l1_n7_m5 l1_n7_m7
//: names    order=8 l2_n2_m2 l2_n4_m2 l2_n4_m4 l2_n6_m2 l2_n6_m4 l2_n6_m6 l2_n8_m2 l2_n8_m4 l2_n8_m6 l2_n8_m8
//: names    order=8 l3_n3_m3 l3_n5_m3 l3_n5_m5 l3_n7_m3 l3_n7_m5 l3_n7_m7
//: names    order=8 l4_n4_m4 l4_n6_m4 l4_n6_m6 l4_n8_m4 l4_n8_m6 l4_n8_m8
//: names    order=8 l5_n5_m5 l5_n7_m5 l5_n7_m7 l6_n6_m6 l6_n8_m6 l6_n8_m8 l7_n7_m7 l8_n8_m8

// The modes of one azimuthal order l, without r^l and cos(l dphi). `count` degrees n = l, l+2, ... make
// count (count+1) / 2 pairs n >= m, whose coefficients begin at `first`. x holds r^2 of the light and of the viewer.
// R_n^l(r) / r^l is Jacobi's P_k^(0,l)(2x-1) with k = (n-l)/2, by its recurrence in k: as stable as its values are small,
// where sums of powers would cancel.
float modes(float l, int count, int first, vec3 x)
{
    vec3 P[5];
    P[0] = vec3(1.0);
    P[1] = (l + 2.0) * x - vec3(l + 1.0);
    float k = 1.0;
    for (int i = 2; i < count; ++i) {
        k += 1.0;
        float s = 2.0 * k + l;
        vec3 slope = (s * (s - 2.0)) * (2.0 * x - vec3(1.0)) - vec3(l * l);
        P[i] = ((s - 1.0) * slope * P[i - 1] - (2.0 * (k - 1.0) * (k + l - 1.0) * s) * P[i - 2]) /
               (2.0 * k * (k + l) * (s - 2.0));
    }
    float sum = 0.0;
    float n = l;
    int next = first;
    for (int i = 0; i < count; ++i) {
        vec3 Pn = sqrt(n + 1.0) * P[i];
        n += 2.0;
        float m = l;
        for (int j = 0; j < i; ++j) {
            sum += coefficients[next] * sqrt(0.5 * (m + 1.0)) * (Pn.x * P[j].y + P[j].x * Pn.y);
            m += 2.0;
            ++next;
        }
        sum += coefficients[next] * sqrt(m + 1.0) * (Pn.x * P[i].y);
        ++next;
    }
    return sum;
}

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosL = dot(N, L);
    float cosV = dot(N, V);
    // r^2 = 2 sin^2(theta/2) = 1 - cos(theta), from the chord; c = r_i r_v cos(dphi), from the parts in the tangent plane.
    vec3 x = 0.5 * vec3(dot(N - L, N - L), dot(N - V, N - V), 0.0);
    float c = dot(L - cosL * N, V - cosV * N) / sqrt((1.0 + cosL) * (1.0 + cosV));
    float square = x.x * x.y;
    // (r_i r_v)^l cos(l dphi) by Chebyshev's recurrence: no azimuth, and nothing to divide by at the pole.
    float before = 1.0;
    float now = c;
    int count = order / 2 + 1;
    int first = count * (count + 1) / 2;
    float sum = modes(0.0, count, 0, x);
    float l = 1.0;
    for (int i = 1; i <= order; ++i) {
        count = (order - i) / 2 + 1;
        sum += 1.4142135623730951 * now * modes(l, count, first, x);
        first += count * (count + 1) / 2;
        float after = 2.0 * c * now - square * before;
        before = now;
        now = after;
        l += 1.0;
    }
    return gate(cosL, gate(cosV, 0.5 * cosL * sum)) * I;
}
