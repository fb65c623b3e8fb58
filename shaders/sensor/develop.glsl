// The sensor: the parts of the other files of this folder in their order, for one pixel. The same text runs in core/sensor.
// x and y count from the upper left corner.

uniform int encoding = 1;

float encoded(float linear)
{
    if (encoding == 0)
        return linear;
    return encoding == 1 ? encodeSrgb(linear) : encodeRec709(linear);
}

// What the pixel's three photosites receive.
vec3 arriving(vec3 radiance, int x, int y, int width, int height)
{
    float share = vignetted(squaredRadius(x, y, width, height));
    return vec3(noisy(exposed(radiance.x) * share, x, y, 0), noisy(exposed(radiance.y) * share, x, y, 1),
                noisy(exposed(radiance.z) * share, x, y, 2));
}

vec3 linearOf(vec3 arrived)
{
    return balanced(vec3(collected(arrived.x), collected(arrived.y), collected(arrived.z)));
}

bool isClipped(vec3 arrived, vec3 linear)
{
    return (wellOn == 1 && isAbove(arrived, wellLimit)) || isAbove(linear, 1.0);
}

float codeOf(float linear, int x, int y, int channel)
{
    return quantisedAt(encoded(inRange(responded(linear, channel))), x, y, channel);
}

vec3 shown(vec3 linear, int x, int y)
{
    if (viewKind == 2)
        return falseColor(luminance(linear));
    vec3 seen = viewKind == 1 ? vec3(luminance(linear)) : linear;
    return vec3(codeOf(seen.x, x, y, 0), codeOf(seen.y, x, y, 1), codeOf(seen.z, x, y, 2));
}

vec3 finished(vec3 radiance, vec3 linear, bool clipped, int x, int y)
{
    vec3 code = shown(linear, x, y);
    if (marks == 0)
        return code;
    bool negative = radiance.x < 0.0 || radiance.y < 0.0 || radiance.z < 0.0;
    return painted(code, clipped, negative, isFinite3(radiance), x, y);
}

vec3 develop(vec3 radiance, int x, int y, int width, int height)
{
    vec3 arrived = arriving(radiance, x, y, width, height);
    vec3 linear = linearOf(arrived);
    return finished(radiance, linear, isClipped(arrived, linear), x, y);
}
