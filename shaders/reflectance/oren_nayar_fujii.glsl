//! name      Oren-Nayar, improved by Fujii
//! family    Rough and matte
//! formula   rho I (N.L) (1 + r s / t) / (1 + (1/2 - 2 / (3 pi)) r),  s = L.V - (N.L)(N.V),  t = max(N.L, N.V) where s > 0, else 1
//! citation  Fujii, A tiny improvement of Oren-Nayar reflectance model; named FON in Portsmouth, Kutz and Hill, EON, JCGT 14(1), 2025
//! about     Oren-Nayar's shape without its ring, the dark seam where light and viewer stand square to each other: behind the light it goes on falling instead of standing still. One roughness r from 0 (Lambert) to 1 takes the place of sigma. Light between grooves is lost, so a rough surface is too dark.
//! reciprocal yes
//! passive   yes, for rho <= 1
//! becomes   lambert where rho=kd;r=0 exactly facing

uniform vec3 rho = vec3(0.69, 0.43, 0.29);
//: like     oren_nayar

uniform float r = 0.5;
//: label    Roughness
//: symbol   r
//: slider   0 .. 1
//: legal    0 .. 1
//: tooltip  0 is Lambert, 1 the roughest surface that the formula knows.
//: source   Fujii

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    // 1 + s / t. Behind the light it is 1 + s = (|l + v|^2 + (N.L)^2 + (N.V)^2) / 2, l and v the parts of L and V along
    // the surface: a sum that cancels nothing where both graze from opposite sides and s comes close to -1.
    vec3 sum = (L + V) - (li + lv) * N;
    float towards = max(0.0, dot(L, V) - li * lv) / max(li, lv);
    float profile = min(1.0, 0.5 * (dot(sum, sum) + li * li + lv * lv)) + towards;
    float scale = 1.0 / (1.0 + 0.28779340921080621 * r);
    return gate(min(li, lv), (li * scale * ((1.0 - r) + r * profile)) * (rho * I));
}
