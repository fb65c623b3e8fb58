// The response curve: linear, a power, or a measured curve in texels of even steps from 0 to 1.

uniform int responseKind = 0;
uniform float responsePower = 1.0;
uniform int responseCount = 0;
uniform samplerBuffer responseTexels;

float channelOf(vec4 texel, int channel)
{
    if (channel == 0)
        return texel.x;
    return channel == 1 ? texel.y : texel.z;
}

float onCurve(float light, int channel)
{
    float place = clamp(light, 0.0, 1.0) * float(responseCount - 1);
    int whole = int(place);
    int low = whole < responseCount - 1 ? whole : responseCount - 2;
    float share = place - float(low);
    return mix(channelOf(texelFetch(responseTexels, low), channel),
               channelOf(texelFetch(responseTexels, low + 1), channel), share);
}

// NaN fails the comparison and becomes 0.
float responded(float light, int channel)
{
    if (responseKind == 0)
        return light;
    if (!(light > 0.0))
        return responseKind == 2 ? onCurve(0.0, channel) : 0.0;
    return responseKind == 2 ? onCurve(light, channel) : pow(light, responsePower);
}
