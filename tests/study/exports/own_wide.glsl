//! name       Wide
//! formula    kd I (N.L) and a ring
//! citation   none
//! about      Calls what only texts of one's own may call, to try their export.
//! reciprocal no
//! passive    no
uniform float kd = 0.5;
//: slider     0 .. 1
//: legal      0 .. 10

const float width = 0.25;

float ring(float angle)
{
    if (angle > 1.5)
        return 0.0;
    return exp(-angle * angle / width) + 0.1 * sin(angle) * sign(angle) + 0.05 * atan(angle, 2.0);
}

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float cosine = dot(N, L);
    vec3 H = normalize(L + V + 0.001 * N);
    float sum = 0.0;
    for (int i = 1; i < 3; ++i)
        sum += float(i) * ring(acos(clamp(dot(N, H), -0.99, 0.99)));
    return gate(cosine, (kd * cosine + 0.1 * sum * length(L)) * I);
}
