//! name      Measured table
//! family    From measurements
//! formula   pi f(theta_i, theta_r, dphi) I (N.L)
//! citation  A measurement, read from a file; its own format says how it was made
//! about     What a real surface was measured to do, looked up between the samples of a file. Nothing is extrapolated: where nothing was measured the surface is black, and striped where the picture shows holes.
//! reciprocal yes, as far as the measurement is
//! passive   yes, as far as the measurement is

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    return gate(cosine, 3.141592653589793 * cosine * tableAt(N, L, V, I));
}
