// The textbook's form. The dot product's rounding is raised to the n-th power with it: about 3 n units in the last place
// are lost, at the very peak too, and GLSL's pow loses more of its own.
float lobe(vec3 R, vec3 V, float n)
{
    float cosine = dot(R, V);
    return gate(cosine, pow(max(cosine, 1e-30), n));
}
