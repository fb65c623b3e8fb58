//! name       Flat
//! formula    kd I (N.L)
//! citation   Lambert, Photometria, 1760
//! about      A diffuser, as one writes a first model of one's own.
//! reciprocal yes
//! passive    yes, for kd <= 1
uniform float kd = 0.5;
//: label      Albedo
//: slider     0 .. 1
//: legal      0 .. 10

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return kd * max(dot(N, L), 0.0) * I;
}
