// Exposure: shutter, aperture and ISO, or EV, as one factor; made in double outside.

uniform float gain = 1.0;

float exposed(float radiance)
{
    return radiance * gain;
}
