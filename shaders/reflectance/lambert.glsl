//! name      Lambert
//! family    Matte
//! formula   kd I (N.L)
//! citation  Lambert, Photometria, 1760
//! about     A perfectly matte surface: light arriving is spread evenly, so brightness depends on the light's angle alone and not on yours. One number kd for all three sensors: a grey surface.
//! reciprocal yes
//! passive   yes, for kd <= 1

uniform float kd = 0.8;
//: label    Diffuse albedo
//: symbol   k_d
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Share of the arriving light that is spread evenly in all directions.
//: source   Lambert 1760

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return kd * I * max(0.0, dot(N, L));
}
