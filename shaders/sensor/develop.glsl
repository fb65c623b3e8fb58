// The sensor: exposure, clipping, and the exact sRGB curve (IEC 61966-2-1:1999).
// The same text runs in core/sensor. Quantisation to 8 bits, floor(255 x + 1/2), follows outside.

uniform float exposure = 0.0;

float encodeSrgb(float linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

// The comparison is false for NaN, which therefore becomes 0, as every negative value does.
float developChannel(float radiance)
{
    float exposed = radiance * exp2(exposure);
    return exposed > 0.0 ? encodeSrgb(min(exposed, 1.0)) : 0.0;
}

vec3 develop(vec3 radiance)
{
    return vec3(developChannel(radiance.x), developChannel(radiance.y), developChannel(radiance.z));
}
