//! name      Lambert, colour
//! family    Matte
//! formula   K I (N.L)
//! citation  Lambert, Photometria, 1760; K is 3x3 because the sensor's red, green and blue filters overlap
//! about     Lambert for three sensors and three light primaries: K[i][j] says how much of light primary j reaches sensor i. A diagonal K is the usual cheat.
//! reciprocal yes
//! passive   yes, where K has no negative entry and no row sum above 1
//! becomes   lambert where K=kd exactly

uniform mat3 K = transpose(mat3(0.62, 0.05, 0.02,
                                0.06, 0.34, 0.03,
                                0.02, 0.05, 0.22));
//: label    Colour matrix
//: symbol   K
//: slider   -0.2 .. 1
//: legal    -inf .. inf
//: tooltip  Row i: what sensor i (red, green, blue) sees of each light primary. Off-diagonals come from overlapping filters.
//: source   Lecture: K is full because the filters overlap

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return K * I * max(0.0, dot(N, L));
}
