// c / (n - n c + c). Schlick, A fast alternative to Phong's specular model, Graphics Gems IV, 1994. Right at the peak and
// where c is 0; between, it glows.
float lobe(vec3 R, vec3 V, float n)
{
    float cosine = min(dot(R, V), 1.0);
    return gate(cosine, cosine / (n - n * cosine + cosine));
}
