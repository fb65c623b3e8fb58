//! name      Blinn-Phong, normalised
//! family    Highlights
//! formula   K I (N.L) + ks I (n + 2) / 2 (N.H)^n (N.L),  H = (L + V) / |L + V|
//! citation  Ngan, Durand and Matusik, Experimental analysis of BRDF models, EGSR 2005: their form of Blinn 1977
//! about     Blinn-Phong as published fits to measured surfaces use it: the BRDF K / pi + ks (n + 2) / (2 pi) (N.H)^n, with the light's cosine. (n + 2) / 2 is what normalises Phong's lobe about R; about H it is up to four times too high, so ks is a coefficient, not a share of the light, and fitted values are small.
//! reciprocal yes
//! passive   no: the height is up to four times what keeps the light, and K is added
//! becomes   lambert_color where ks=0 exactly

uniform vec3 ks = vec3(0.1);
//: label    Specular coefficient
//: symbol   k_s
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Times (n + 2) / 2 it is the height of the highlight. One number keeps the light's colour; three tint it.
//: source   Ngan, Durand and Matusik 2005

uniform float n = 160.0;
//: like     blinn_phong

uniform mat3 K = transpose(mat3(0.0));
//: like     lambert_color

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    vec3 gloss = (0.5 * (n + 2.0)) * lobe(N, halfway(L, V), n) * ks * I;
    return gate(cosine, cosine * (K * I + gloss));
}
