//! name      Oren-Nayar
//! family    Rough and matte
//! formula   rho I (N.L) (A + B max(0, s) / t),  s = L.V - (N.L)(N.V),  t = max(N.L, N.V),  A = 1 - 0.5 sigma^2 / (sigma^2 + 0.33),  B = 0.45 sigma^2 / (sigma^2 + 0.09)
//! citation  Oren and Nayar, Generalization of Lambert's reflectance model, SIGGRAPH 1994: the qualitative form with A and B
//! about     A matte surface with a rough profile, like clay, plaster or sand: countless small grooves, each of them Lambertian, that shadow and hide one another. Seen from near the light it stays bright to its very edge, so a round body looks flat. With sigma = 0 it is Lambert. Light between grooves is left out.
//! reciprocal yes
//! passive   no: smooth surfaces (sigma below 0.35) return up to 1.5 % more than arrives from near grazing light
//! becomes   lambert where rho=kd;sigma=0 exactly facing

uniform vec3 rho = vec3(0.69, 0.43, 0.29);
//: label    Albedo
//: symbol   rho
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Share of the light that each groove wall spreads, for red, green and blue; one number is grey.
//: source   Oren and Nayar 1994; the default is a reddish clay

uniform float sigma = 0.4;
//: label    Roughness
//: symbol   sigma
//: unit     rad
//: slider   0 .. 1.5
//: legal    0 .. inf
//: tooltip  Spread of the grooves' slopes: the standard deviation of their angle in radians. 0 is Lambert; 0.35 to 0.7 (20 to 40 degrees) are plaster, sand and clay; above 1.5 the model says little.
//: source   Oren and Nayar 1994; some programs take degrees, or sqrt(2) sigma

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    // The angle form B max(0, cos dphi) sin(alpha) tan(beta) is B max(0, s) / t: no arc cosine loses digits near N, no
    // tangent overflows at the horizon.
    float li = dot(N, L);
    float lv = dot(N, V);
    float slope = min(sigma, 1e9); // beyond, A and B no longer change; its square stays finite
    float variance = slope * slope;
    float A = 1.0 - 0.5 * variance / (variance + 0.33);
    float B = 0.45 * variance / (variance + 0.09);
    float bracket = A + B * max(0.0, dot(L, V) - li * lv) / max(li, lv);
    return gate(min(li, lv), (li * bracket) * (rho * I));
}
