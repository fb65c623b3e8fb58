// What of the developed picture is looked at: luminance (ITU-R BT.709-6), false colours of one stop each, painted marks.

uniform int viewKind = 0;
uniform int marks = 0;
uniform float falseColors[36];

float luminance(vec3 light)
{
    return dot(vec3(0.2126, 0.7152, 0.0722), light);
}

// The band of a luminance relative to white: 0 below 2^-8, then one per stop, 11 from 2^2 on.
int bandOf(float light)
{
    int band = 0;
    for (float edge = 0.00390625; band < 11 && light >= edge; edge = edge * 2.0)
        band = band + 1;
    return band;
}

vec3 falseColor(float light)
{
    int band = 3 * bandOf(light);
    return vec3(falseColors[band], falseColors[band + 1], falseColors[band + 2]);
}

// False for NaN, too: it compares with nothing.
bool isFinite3(vec3 v)
{
    return abs(v.x) <= 3.0e38 && abs(v.y) <= 3.0e38 && abs(v.z) <= 3.0e38;
}

bool isAbove(vec3 v, float limit)
{
    return v.x > limit || v.y > limit || v.z > limit;
}

// Stripes that rise to the right for clipped, to the left for negative, all over for what is no number.
vec3 painted(vec3 code, bool clipped, bool negative, bool finite, int x, int y)
{
    if (!finite)
        return vec3(1.0, 0.0, 0.784);
    if (clipped && (x + y) % 8 < 3)
        return vec3(0.93, 0.35, 0.0);
    if (negative && (x + 8000000 - y) % 8 < 3)
        return vec3(0.0, 0.55, 1.0);
    return code;
}
