//! name      Perfect mirror
//! family    Mirror
//! formula   L_out(V) = reflectance * I(R),  R = 2N(N.V) - V
//! citation  Law of reflection; the reflected light keeps the light's colour
//! about     You see the surroundings along the mirrored view: the environment, and each light as a disc of its angular radius. A light without extent (radius 0) is met by no view direction, so it adds exactly 0.
//! reciprocal yes
//! passive   yes, for reflectance <= 1

uniform float reflectance = 0.9;
//: label    Mirror reflectance
//: symbol   r
//: slider   0 .. 1
//: legal    0 .. inf
//: tooltip  Share of the light that the mirror returns, the same for every colour.
//: source   Law of reflection

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return gate(dot(N, L), reflectance * insideLight(mirrored(N, L), V) * I);
}

vec3 shadeEnvironment(vec3 N, vec3 V)
{
    return reflectance * environment(mirrored(N, V));
}
