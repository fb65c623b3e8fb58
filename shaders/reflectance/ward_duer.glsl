//! name      Ward-Duer
//! family    Tiny mirrors
//! formula   K I (N.L) + ks I exp(-tan(h)^2 / alpha^2) / (4 alpha^2 (N.V)),  h the angle between N and H = (L + V) / |L + V|
//! citation  Duer, An improved normalization for the Ward reflectance model, Journal of Graphics Tools 11(1), 2006
//! about     Ward's highlight divided by (N.L)(N.V) in place of its root, which keeps its share of the light up to lower sun: the BRDF K / pi + ks exp(-tan(h)^2 / alpha^2) / (4 pi alpha^2 (N.L)(N.V)). Towards the horizon it grows faster still.
//! reciprocal yes
//! passive   no: it grows without bound towards the horizon, and K is added
//! becomes   lambert_color where ks=0 exactly facing

uniform vec3 ks = vec3(0.1);
//: like     ward

uniform float alpha = 0.15;
//: like     ward

uniform mat3 K = transpose(mat3(0.0));
//: like     lambert_color

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    vec3 H = halfway(L, V);
    vec3 slant = cross(N, H);
    float nh = dot(N, H);
    float slope = min(dot(slant, slant) / (nh * nh), 1e12); // tan(h)^2, finite also where H lies in the surface
    float square = alpha * alpha;
    float gloss = expOrZero(-slope / square) * 0.25 / square / lv;
    return gate(min(li, lv), li * (K * I) + gloss * ks * I);
}
