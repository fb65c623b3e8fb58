// Shot and read noise, drawn from a normal distribution by Box and Muller (1958). The random numbers are hashes of pixel,
// channel, stream and seed, so that no order of computation changes them. The hash is PCG's (O'Neill 2014) as Jarzynski and Olano
// recommend it, Hash Functions for GPU Rendering, JCGT 9(3), 2020.

uniform int noiseOn = 0;
uniform float shotVariance = 0.0;
uniform float readVariance = 0.0;
uniform int seed = 0;

uint scrambled(uint v)
{
    uint state = v * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Within 0 .. 1, both ends excluded. 23 bits and a half: exact in float.
float uniformly(int x, int y, int channel, int stream)
{
    uint drawn = scrambled(uint(x) + scrambled(uint(y) + scrambled(uint(3 * stream + channel) + scrambled(uint(seed)))));
    return (float(drawn >> 9u) + 0.5) / 8388608.0;
}

float normally(int x, int y, int channel)
{
    float squared = -2.0 * log(uniformly(x, y, channel, 0));
    return sqrt(squared) * cos(6.283185307179586 * uniformly(x, y, channel, 1));
}

float noisy(float light, int x, int y, int channel)
{
    if (noiseOn == 0)
        return light;
    return light + sqrt(shotVariance * max(light, 0.0) + readVariance) * normally(x, y, channel);
}
