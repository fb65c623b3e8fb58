//! name      EON
//! family    Rough and matte
//! formula   I (N.L) (rho A (1 + r s / t) + rho_m (1 - E(N.L)) (1 - E(N.V)) / (1 - <E>)),  A = 1 / (1 + (1/2 - 2 / (3 pi)) r),  rho_m = rho^2 <E> / (1 - rho (1 - <E>)),  s and t as Fujii's, E the share that the first term returns and <E> its mean
//! citation  Portsmouth, Kutz and Hill, EON: a practical energy-preserving rough diffuse BRDF, JCGT 14(1), 2025
//! about     Fujii's rough matte surface with the light that grooves return after several bounces, so that none is lost: a white surface in white surroundings stays white, whatever its roughness. The albedo E of the first bounce is taken in its exact form.
//! reciprocal yes
//! passive   yes: with rho = 1 it returns all light, and not more
//! becomes   lambert where rho=kd;r=0

uniform vec3 rho = vec3(0.69, 0.43, 0.29);
//: like     oren_nayar
//: legal    0 .. 1
//: tooltip  Share of the light that the surface returns in each colour, near enough whatever its roughness. Above 1 the light between the grooves would never die out.

uniform float r = 0.5;
//: like     oren_nayar_fujii

// C1 - G / pi, the share 1 - E without its factor A r. (S / mu)(1 - S^3) is written S mu (1 + S + S^2) / (1 + S), which is
// no 0/0 at the horizon; S and the angle come from N x A and N - A, which lose nothing near N.
float lost(vec3 N, vec3 A)
{
    float mu = dot(N, A);
    vec3 across = cross(N, A);
    float S = sqrt(dot(across, across));
    float G = S * (angleBetween(N, A) - S * mu) + 2.0 / 3.0 * S * (mu * (1.0 + S + S * S) / (1.0 + S) - 1.0);
    return 0.28779340921080621 - 0.31830988618379067 * G;
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
