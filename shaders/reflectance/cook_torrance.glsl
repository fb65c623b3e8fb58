//! name      Cook-Torrance
//! family    Tiny mirrors
//! formula   K I (N.L) + ks I F D G pi / (4 (N.V)),  D = exp(-tan(h)^2 / m^2) / (pi m^2 cos(h)^4),  G = min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H)),  F = f0 + (1 - f0) (1 - V.H)^5,  h the angle between N and H
//! citation  Cook and Torrance, A reflectance model for computer graphics, ACM TOG 1(1), 1982; F by Schlick 1994
//! about     A surface of tiny mirrors whose slopes spread by m (Beckmann), which shade and hide one another in V-shaped grooves (G) and reflect more at glancing angles (F). The BRDF is K / pi + ks F D G / (4 (N.L)(N.V)), what flat facets give. The paper prints pi where 4 stands and its D without pi, four times as much; the fits of Ngan et al. 2005 divide a D with pi by pi once more, so their ks is pi / 4 of the one here.
//! reciprocal yes
//! passive   no: K is added to what the facets return
//! becomes   lambert_color where ks=0 exactly facing

uniform float m = 0.25;
//: label    Slope of the facets
//: symbol   m
//: slider   0.01 .. 1 log
//: legal    1e-4 .. 10
//: tooltip  Root mean square slope of the facets. Small: a sharp highlight; fits to measured surfaces lie from 0.005 (polished metal) to 1 (felt).
//: source   Beckmann and Spizzichino 1963; Cook and Torrance 1982

uniform vec3 f0 = vec3(0.06);
//: label    Facing reflectance
//: symbol   f_0
//: slider   0 .. 1
//: legal    0 .. 1
//: tooltip  What a facet reflects when looked at straight on: 0.02 to 0.08 for everything but metals, 0.5 to 1 and coloured for metals. One number is grey.
//: source   Fresnel 1823; Schlick, An inexpensive BRDF model for physically-based rendering, 1994

uniform vec3 ks = vec3(1.0);
//: label    Specular share
//: symbol   k_s
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  How much of the facets' reflection is there: 1 is all of it. One number keeps its colour; three tint it.
//: source   s in Cook and Torrance 1982

uniform mat3 K = transpose(mat3(0.0));
//: like     lambert_color

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    vec3 H = halfway(L, V);
    vec3 slant = cross(N, H); // sin(h), without forming 1 - (N.H)^2
    float nh = dot(N, H);
    float slope = min(dot(slant, slant) / (nh * nh), 1e12); // tan(h)^2, finite also where H lies in the surface
    float steep = 1.0 + slope;                              // 1 / cos(h)^2
    float D = expOrZero(-slope / (m * m)) * (steep * steep) / (m * m);
    vec3 sum = L + V;
    float vh = max(0.5 * sqrt(dot(sum, sum)), 1e-18); // V.H = |L + V| / 2
    float open = min(0.25 / lv, 0.5 * nh / vh * min(1.0, li / lv)); // G / (4 (N.V)), without dividing a 0 by a 0
    vec3 apart = V - H;
    float u = 0.5 * dot(apart, apart); // 1 - V.H
    vec3 F = f0 + (u * u * u * u * u) * (vec3(1.0) - f0);
    return gate(min(li, lv), li * (K * I) + (D * open) * F * ks * I);
}
