//! name      GGX
//! family    Tiny mirrors
//! formula   I (N.L) F D pi W,  D = alpha^2 / (pi ((N.H)^2 (alpha^2 - 1) + 1)^2),  W = 1 / (2 (N.L) sqrt(alpha^2 + (1 - alpha^2)(N.V)^2) + 2 (N.V) sqrt(alpha^2 + (1 - alpha^2)(N.L)^2)),  F = f0 + (1 - f0) (1 - V.H)^5,  H = (L + V) / |L + V|
//! citation  Walter, Marschner, Li and Torrance, Microfacet models for refraction through rough surfaces, EGSR 2007; Trowbridge and Reitz 1975; height-correlated W: Heitz, JCGT 3(2), 2014
//! about     A surface of tiny mirrors with more steep ones than Beckmann's, so that the highlight fades into a wide glow: what most renderers use today. W is the height-correlated shadowing of Smith, F is Schlick's Fresnel term; the BRDF is F D W. Light between facets is lost: a rough white surface returns 31 % of it at normal incidence. alpha is the roughness itself; programs whose slider is its root give alpha = roughness^2.
//! reciprocal yes
//! passive   yes, for f0 <= 1

uniform float alpha = 0.3;
//: label    Roughness
//: symbol   alpha
//: slider   0.01 .. 1 log
//: legal    1e-4 .. 1
//: tooltip  Width of the facets' slopes. 0.02 is polished, 0.3 satin, 1 as rough as it gets. Some programs take its square root.
//: source   Walter et al. 2007

uniform vec3 f0 = vec3(0.955, 0.638, 0.538);
//: like     cook_torrance

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    float square = alpha * alpha;
    vec3 H = halfway(L, V);
    vec3 slant = cross(N, H);
    float nh = dot(N, H);
    // (N.H)^2 (alpha^2 - 1) + 1 is sin(h)^2 + alpha^2 cos(h)^2: a sum, where the difference rounds to 0 in float.
    float D = alpha / (dot(slant, slant) + square * (nh * nh));
    float hiddenL = lv * sqrt(square + (1.0 - square) * (li * li));
    float hiddenV = li * sqrt(square + (1.0 - square) * (lv * lv));
    vec3 apart = V - H;
    float u = 0.5 * dot(apart, apart); // 1 - V.H
    vec3 F = f0 + (u * u * u * u * u) * (vec3(1.0) - f0);
    return gate(min(li, lv), (D * D) * (0.5 * li / (hiddenL + hiddenV)) * F * I);
}
