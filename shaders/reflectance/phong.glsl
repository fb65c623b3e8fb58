//! name      Phong
//! family    Highlights
//! formula   ks I (R.V)^n,  R = 2N(N.L) - L
//! citation  Phong, Illumination for Computer Generated Pictures, CACM 18(6), 1975
//! about     A glossy highlight alone: brightest where you look along the mirrored light R, fading with the n-th power of the cosine. The highlight keeps the light's colour.
//! reciprocal no: the factor lacks the cosine, so exchanging light and viewer changes the BRDF
//! passive   no: the factor lacks the cosine, so near grazing light every highlight returns more than arrives, a broad one first

uniform vec3 ks = vec3(0.5);
//: label    Specular strength
//: symbol   k_s
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Height of the highlight: the factor at its peak, where V = R. One number, so that it keeps the light's colour; three, an extension of the lecture, tint it.
//: source   Phong 1975

uniform float n = 40.0;
//: label    Phong exponent
//: symbol   n
//: slider   1 .. 10000 log
//: legal    0 .. 1e7
//: tooltip  Larger n: a smaller, sharper highlight. Its half-maximum radius is about 67 / sqrt(n) degrees.
//: source   Phong 1975; measured surfaces have a median near 215 (Ngan et al. 2005, Blinn-Phong fits)

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return gate(dot(N, L), ks * lobe(mirrored(N, L), V, n) * I);
}
