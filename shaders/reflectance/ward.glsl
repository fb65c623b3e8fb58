//! name      Ward
//! family    Tiny mirrors
//! formula   K I (N.L) + ks I exp(-tan(h)^2 / alpha^2) / (4 alpha^2) sqrt((N.L) / (N.V)),  h the angle between N and H = (L + V) / |L + V|
//! citation  Ward, Measuring and modeling anisotropic reflection, SIGGRAPH 1992: the isotropic form
//! about     A highlight made to be fitted to measurements: a Gaussian of the half vector's slope, with as few parameters as do. This is the isotropic form of 1992, the BRDF K / pi + ks exp(-tan(h)^2 / alpha^2) / (4 pi alpha^2 sqrt((N.L)(N.V))), the one of the fits of Ngan et al. 2005. For a viewer towards the horizon it grows without bound.
//! reciprocal yes
//! passive   no: it grows without bound for a viewer towards the horizon, and K is added
//! becomes   lambert_color where ks=0 exactly facing

uniform vec3 ks = vec3(0.1);
//: label    Specular albedo
//: symbol   k_s
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  About the share of the light that the highlight returns near normal incidence. One number keeps the light's colour; three tint it.
//: source   Ward 1992

uniform float alpha = 0.15;
//: label    Roughness
//: symbol   alpha
//: slider   0.005 .. 1 log
//: legal    1e-4 .. 1
//: tooltip  Standard deviation of the surface's slope. Measured surfaces lie from 0.005 (polished metal) to 0.5 (felt).
//: source   Ward 1992

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
    float gloss = expOrZero(-slope / square) * 0.25 / square * sqrt(li / lv);
    return gate(min(li, lv), li * (K * I) + gloss * ks * I);
}
