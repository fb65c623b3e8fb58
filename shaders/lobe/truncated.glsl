// (1 - n (1 - c) / k)^k, 0 where the bracket is negative: equal to c^n at k = n and to exp(-n (1 - c)) in the limit. k is
// the power of two nearest to n, at most 16, so that a few squarings do.
float lobe(vec3 R, vec3 V, float n)
{
    float cosine = dot(R, V);
    int squarings = squaringsFor(n);
    float k = 1.0;
    for (int i = 0; i < squarings; ++i)
        k = k * 2.0;
    float product = max(1.0 - (n / k) * (1.0 - cosine), 0.0);
    for (int i = 0; i < squarings; ++i)
        product = product * product;
    return gate(cosine, product);
}
