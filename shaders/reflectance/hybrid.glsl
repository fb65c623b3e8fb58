//! name      Hybrid
//! family    Highlights
//! formula   K I (N.L) + ks I (R.V)^n,  R = 2N(N.L) - L
//! citation  Lambert 1760 + Phong, Illumination for Computer Generated Pictures, CACM 18(6), 1975
//! about     Lambert in colour plus a Phong highlight: a matte body that takes its colour from K, and a gloss that keeps the colour of the light.
//! reciprocal no: its Phong term is not
//! passive   no: its Phong term is not
//! becomes   lambert_color where ks=0 exactly
//! becomes   phong where K=0 exactly

uniform mat3 K = transpose(mat3(0.62, 0.05, 0.02,
                                0.06, 0.34, 0.03,
                                0.02, 0.05, 0.22));
//: like     lambert_color

uniform vec3 ks = vec3(0.25);
//: like     phong

uniform float n = 40.0;
//: like     phong

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    return gate(cosine, cosine * (K * I) + ks * lobe(mirrored(N, L), V, n) * I);
}
