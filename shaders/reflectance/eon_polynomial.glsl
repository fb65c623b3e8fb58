//! name      EON, polynomial albedo
//! family    Rough and matte
//! formula   I (N.L) (rho A (1 + r s / t) + rho_m (1 - E(N.L)) (1 - E(N.V)) / (1 - <E>)),  A = 1 / (1 + (1/2 - 2 / (3 pi)) r),  rho_m = rho^2 <E> / (1 - rho (1 - <E>)),  s and t as Fujii's, E the share that the first term returns and <E> its mean
//! citation  Portsmouth, Kutz and Hill, EON: a practical energy-preserving rough diffuse BRDF, JCGT 14(1), 2025: the albedo as a polynomial of degree 4
//! about     EON with the albedo E of the first bounce as a polynomial, as renderers take it: it needs no angle, and E is off by at most 0.0005. Beside EON it shows what that costs. Where the polynomial would return more than arrives, 1 - E is 0.
//! reciprocal yes
//! passive   no: at some angles it returns up to 0.0005 more than arrives, the price of the polynomial
//! becomes   lambert where rho=kd;r=0

uniform vec3 rho = vec3(0.69, 0.43, 0.29);
//: like     oren_nayar
//: legal    0 .. 1
//: tooltip  Share of the light that the surface returns in each colour, near enough whatever its roughness. Above 1 the light between the grooves would never die out.

uniform float r = 0.5;
//: like     oren_nayar_fujii

// C1 - G / pi with G / pi as a polynomial in 1 - cos.
float lost(vec3 N, vec3 A)
{
    float m = 1.0 - dot(N, A);
    return max(0.0, 0.28779340921080621 -
                        m * (0.0571085289 + m * (0.491881867 + m * (0.0714429953 * m - 0.332181442))));
}

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    vec3 sum = (L + V) - (li + lv) * N; // see oren_nayar_fujii
    float towards = max(0.0, dot(L, V) - li * lv) / max(li, lv);
    float profile = min(1.0, 0.5 * (dot(sum, sum) + li * li + lv * lv)) + towards;
    float scale = 1.0 / (1.0 + 0.28779340921080621 * r);
    // 1 - E = A r lost and 1 - <E> = A r (C1 - C2), C1 - C2 = 6 / (5 pi) - 1/6: with A r taken out of each, r = 0 makes
    // no 0/0.
    float meanLost = scale * r * 0.21530519675388218;
    float many = scale * r * lost(N, L) * lost(N, V) / 0.21530519675388218;
    vec3 again = rho * rho * (1.0 - meanLost) / (vec3(1.0) - meanLost * rho);
    return gate(min(li, lv), li * (scale * ((1.0 - r) + r * profile) * rho + many * again) * I);
}
