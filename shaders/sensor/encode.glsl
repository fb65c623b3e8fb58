// From linear 0 .. 1 to encoded 0 .. 1.

// The exact sRGB curve (IEC 61966-2-1:1999).
float encodeSrgb(float linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

// The camera's curve of ITU-R BT.709-6, item 1.2.
float encodeRec709(float linear)
{
    return linear < 0.018 ? 4.5 * linear : 1.099 * pow(linear, 0.45) - 0.099;
}

// The comparison is false for NaN, which therefore becomes 0, as every negative value does.
float inRange(float value)
{
    return value > 0.0 ? min(value, 1.0) : 0.0;
}
