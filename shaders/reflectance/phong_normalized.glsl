//! name      Phong, normalised
//! family    Highlights
//! formula   ks I (n + 2) / 2 (R.V)^n (N.L),  R = 2N(N.L) - L
//! citation  Lafortune and Willems, Using the modified Phong reflectance model for physically based rendering, 1994
//! about     Phong with the light's cosine and a height that grows with n, so that a sharper highlight is a brighter one and ks is the share of the light that it returns: all of ks at normal incidence, less towards the horizon, where the lobe is cut. As a BRDF ks (n + 2) / (2 pi) (R.V)^n.
//! reciprocal yes
//! passive   yes, for ks <= 1

uniform vec3 ks = vec3(0.5);
//: label    Specular albedo
//: symbol   k_s
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Share of the light that the highlight returns at normal incidence. One number keeps the light's colour; three tint it.
//: source   Lafortune and Willems 1994

uniform float n = 40.0;
//: like     phong

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    return gate(cosine, (0.5 * (n + 2.0)) * cosine * lobe(mirrored(N, L), V, n) * ks * I);
}
