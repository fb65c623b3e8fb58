// The surroundings as a latitude-longitude picture; core/illumination/environment.h states the convention, and
// environment.cpp is its C++ side. Rotation and factor are applied outside.

uniform sampler2D environmentMap; // row 0 is the top row (+y)

// atan for |t| <= tan(pi/8): the series up to t^15; the first term left out is below 2e-8.
float arcOf(float t)
{
    float z = t * t;
    return t - t * z * (1.0 / 3.0 - z * (1.0 / 5.0 - z * (1.0 / 7.0 - z * (1.0 / 9.0 -
               z * (1.0 / 11.0 - z * (1.0 / 13.0 - z * (1.0 / 15.0)))))));
}

// atan2(y, x) to 3e-7; GLSL's own may be wrong by 1.6e-4, which shows on a map of 4096 columns.
float angleOf(float y, float x)
{
    float larger = max(abs(x), abs(y));
    float smaller = min(abs(x), abs(y));
    if (!(larger > 0.0))
        return 0.0;
    // atan(t) = pi/4 + atan((t-1)/(t+1)) brings steep angles back into the series' range.
    float angle = smaller > 0.41421356 * larger ? 0.78539816 + arcOf((smaller - larger) / (smaller + larger))
                                                : arcOf(smaller / larger);
    angle = abs(y) > abs(x) ? 1.57079633 - angle : angle;
    angle = x < 0.0 ? 3.14159265 - angle : angle;
    return y < 0.0 ? -angle : angle;
}

// Wraps round in longitude, stays inside in latitude.
vec3 mapTexel(int column, int row)
{
    ivec2 size = textureSize(environmentMap, 0);
    return texelFetch(environmentMap, ivec2((column + size.x) % size.x, clamp(row, 0, size.y - 1)), 0).rgb;
}

// d is a unit vector that points away from the object. The four texels are weighted here, in float: a texture unit
// would weight them with 8 bits.
vec3 mapRadiance(vec3 d)
{
    vec2 size = vec2(textureSize(environmentMap, 0));
    float x = (0.5 + angleOf(d.x, -d.z) / 6.28318531) * size.x - 0.5;
    float y = angleOf(sqrt(d.x * d.x + d.z * d.z), d.y) / 3.14159265 * size.y - 0.5;
    int column = int(floor(x));
    int row = int(floor(y));
    vec3 above = mix(mapTexel(column, row), mapTexel(column + 1, row), x - floor(x));
    vec3 below = mix(mapTexel(column, row + 1), mapTexel(column + 1, row + 1), x - floor(x));
    return mix(above, below, y - floor(y));
}
