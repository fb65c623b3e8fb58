// Quantisation to levels + 1 values: to the nearest, ties up; dithered, up as often as the fraction says.

uniform float levels = 255.0;
uniform int dithered = 0;

float quantisedAt(float value, int x, int y, int channel)
{
    if (levels == 0.0)
        return value;
    float shift = dithered == 1 ? uniformly(x, y, channel, 2) : 0.5;
    return floor(levels * value + shift) / levels;
}
