// Light lost towards the corners: cos^4 of the angle to the axis (thin lens, Hecht, Optics), or a polynomial in r^2.

uniform int vignettingKind = 0;
uniform float cornerTangent = 0.0;
uniform vec3 fallOff = vec3(0.0, 0.0, 0.0);

// Of the middle of pixel (x, y): the squared distance from the picture's middle, 1 in the corners.
float squaredRadius(int x, int y, int width, int height)
{
    float across = float(2 * x + 1 - width);
    float down = float(2 * y + 1 - height);
    return (across * across + down * down) / (float(width) * float(width) + float(height) * float(height));
}

float vignetted(float rr)
{
    if (vignettingKind == 1) {
        float squaredCosine = 1.0 / (1.0 + rr * cornerTangent * cornerTangent);
        return squaredCosine * squaredCosine;
    }
    if (vignettingKind == 2)
        return max(1.0 + rr * (fallOff.x + rr * (fallOff.y + rr * fallOff.z)), 0.0);
    return 1.0;
}
