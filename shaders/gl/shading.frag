// Shades the kept samples of one pixel and averages them: the lecture's sum over the lights. Linear, never clamped.
// Loops ask at their end: a software driver runs the body of a loop that asks at its head once more, masked, and here the
// bodies stand in each other.
uniform usampler2D triangles; // 1 + the number of the triangle that a sample sees, 0: none
uniform sampler2D normals;    // N, where something is seen
#ifdef POSITIONS
uniform sampler2D positions;  // P, the same
vec3 positionAt(ivec2 texel) { return texelFetch(positions, texel, 0).xyz; }
#else
vec3 positionAt(ivec2 texel) { return vec3(0.0); } // nobody asks
#endif
uniform int samplesPerAxis;
uniform int lightCount;
uniform vec3 eye;
uniform vec3 backgroundColor;

layout(location = 0) out vec4 radianceAndCoverage;

vec3 shadeSample(vec3 N, vec3 P)
{
    vec3 V = normalize(eye - P);
    vec3 sum = vec3(0.0);
#ifdef TABLE_HOLES
    tableHoles = 0.0;
#endif
#if defined(DIRECTIONAL_LIGHTS) || defined(POINT_LIGHTS)
    int light = 0; // there is at least one
    do {
        arrive(light, P);
        sum += shade(N, L, V, I);
    } while (++light < lightCount);
#endif
#ifdef ENVIRONMENT
    sum += shadeEnvironment(N, V);
#endif
#ifdef TABLE_HOLES
    if (tableHoles > 0.0)
        sum = holeColor(P);
#endif
    return sum;
}

vec3 shadeAt(ivec2 texel)
{
    return shadeSample(texelFetch(normals, texel, 0).xyz, positionAt(texel));
}

vec3 backgroundAt(ivec2 texel)
{
#ifdef ENVIRONMENT_BACKGROUND
    return environment(normalize(sampleRay(texel)));
#else
    return backgroundColor;
#endif
}

#ifdef ONCE_PER_PIXEL
// The middle one of the pixel's covered samples stands for all of them; from the top row, as the CPU renderer counts.
vec3 shadeMiddle(ivec2 first, int hits)
{
    int before = hits / 2;
    ivec2 middle = first;
    ivec2 at = ivec2(0, samplesPerAxis - 1);
    do {
        if (texelFetch(triangles, first + at, 0).x != 0u && before-- == 0)
            middle = first + at;
        at.x += 1;
        if (at.x == samplesPerAxis)
            at = ivec2(0, at.y - 1);
    } while (at.y >= 0);
    return shadeAt(middle);
}
#endif

#ifdef ONCE_PER_FRAGMENT
// How many samples this one stands for: those that see its triangle if it is the middle one of them, else none. From the
// top row, as the CPU renderer counts.
float standsFor(ivec2 first, ivec2 texel, uint triangle)
{
    int together = 0;
    int before = 0;
    ivec2 at = ivec2(0, samplesPerAxis - 1);
    do {
        if (first + at == texel)
            before = together;
        together += texelFetch(triangles, first + at, 0).x == triangle ? 1 : 0;
        at.x += 1;
        if (at.x == samplesPerAxis)
            at = ivec2(0, at.y - 1);
    } while (at.y >= 0);
    return before == together / 2 ? float(together) : 0.0;
}
#endif

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samplesPerAxis;
    vec3 sum = vec3(0.0);
    float hits = 0.0;
    ivec2 at = ivec2(0);
    do {
        ivec2 texel = first + at;
        uint triangle = texelFetch(triangles, texel, 0).x;
        if (triangle != 0u) {
#ifdef ONCE_PER_FRAGMENT
            float samples = standsFor(first, texel, triangle);
            if (samples > 0.0)
                sum += samples * shadeAt(texel);
#elif !defined(ONCE_PER_PIXEL)
            sum += shadeAt(texel);
#endif
            hits += 1.0;
        } else {
            sum += backgroundAt(texel);
        }
        at.x += 1;
        if (at.x == samplesPerAxis)
            at = ivec2(0, at.y + 1);
    } while (at.y < samplesPerAxis);
#ifdef ONCE_PER_PIXEL
    if (hits > 0.0)
        sum += hits * shadeMiddle(first, int(hits));
#endif
    float samples = float(samplesPerAxis * samplesPerAxis);
    radianceAndCoverage = vec4(sum / samples, hits / samples);
}
