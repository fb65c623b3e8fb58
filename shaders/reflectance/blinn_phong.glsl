//! name      Blinn-Phong
//! family    Highlights
//! formula   K I (N.L) + ks I (N.H)^n,  H = (L + V) / |L + V|
//! citation  Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH 1977
//! about     A highlight from the half vector H between light and viewer: how far H is from N says how far the surface is from mirroring. 4 n here is as wide as n in Phong, but only in the plane of incidence, to 0.14 / n of the peak. Across it the Blinn highlight is narrower, and the more so towards grazing light: at Phong's n = 50 the two differ by 0.003 of the peak at normal incidence, 0.10 at 30, 0.47 at 60 and 0.87 at 80 degrees. It is another highlight, elongated as real ones are. K adds a matte body; 0 leaves the highlight alone.
//! reciprocal no: the highlight lacks the cosine of the light
//! passive   no: the highlight lacks the cosine, so near grazing light it returns more than arrives
//! becomes   lambert_color where ks=0 exactly

uniform vec3 ks = vec3(0.5);
//: like     phong
//: tooltip  Height of the highlight: the factor at its peak, where H = N. One number keeps the light's colour; three tint it.
//: source   Blinn 1977

uniform float n = 160.0;
//: like     phong
//: slider   1 .. 100000 log
//: legal    0 .. 1e8
//: tooltip  Larger n: a smaller, sharper highlight. In the plane of incidence 4 n looks like Phong's n.
//: source   Blinn 1977; the rule 4 n: Fisher and Woo, Graphics Gems IV, 1994

uniform mat3 K = transpose(mat3(0.0));
//: like     lambert_color

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    return gate(cosine, cosine * (K * I) + lobe(N, halfway(L, V), n) * ks * I);
}
