// For a whole n: the cosine squared again and again, the squares that n's binary digits name multiplied. Exact but for
// the rounding of the dot product and of each product, which n multiplies.
float lobe(vec3 R, vec3 V, float n)
{
    float cosine = dot(R, V);
    float square = max(cosine, 0.0);
    float product = 1.0;
    for (int left = wholeNumber(n); left > 0; left /= 2) {
        if (left % 2 == 1)
            product = product * square;
        square = square * square;
    }
    return gate(cosine, product);
}
