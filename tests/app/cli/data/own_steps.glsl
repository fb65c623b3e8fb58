//! name       Steps
//! formula    steps I floor(4 N.L) / 4
//! citation   none
//! about      Light in four steps, to try what a text of one's own can say.
//! reciprocal no: the steps follow the light
//! passive    yes, for steps <= 1
uniform float steps = 1.0;
//: label      Height
//: slider     0 .. 1
//: legal      0 .. 10

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    float sum = 0.0;
    for (int i = 1; i < 4; ++i) {
        if (4.0 * cosine >= float(i))
            sum += 0.25;
    }
    return gate(cosine, steps * sum * I);
}
