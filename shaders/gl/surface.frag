// From the triangle that a sample sees to the point on it and its normal, as core/render/cpu/surface_point.cpp does:
// the ray is intersected with the triangle itself. The rasteriser's own interpolation is not used, for it snaps corners
// to 1/256 of a sample, and on the slivers of a silhouette that puts P far outside the triangle. Runs only where a triangle
// is seen.
uniform usampler2D triangles;
uniform usamplerBuffer corners; // vertex numbers, three per triangle
uniform samplerBuffer vertices; // position and normal, a texel each
uniform vec3 eye;

layout(location = 0) out vec4 surfaceNormal;
layout(location = 1) out vec4 surfacePosition;

vec3 unitOrZero(vec3 v)
{
    // The largest component is divided out first: opposed vertex normals may all but cancel between corners.
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}

// Weights of the second and third corner, kept inside the triangle; its centre where the ray runs in its plane.
vec2 barycentrics(vec3 fromA, vec3 ray, vec3 edge1, vec3 edge2)
{
    // From the ray's point nearest to A instead of from the eye: what is left is as small as the triangle, and so are its
    // rounding errors.
    fromA -= (dot(fromA, ray) / dot(ray, ray)) * ray;
    vec3 p = cross(ray, edge2);
    vec3 q = cross(fromA, edge1);
    float determinant = dot(edge1, p);
    if (determinant == 0.0)
        return vec2(1.0 / 3.0);
    vec2 uv = max(vec2(dot(fromA, p), dot(ray, q)) / determinant, 0.0);
    return uv / max(uv.x + uv.y, 1.0);
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int first = 3 * (int(texelFetch(triangles, texel, 0).x) - 1);
    int a = 2 * int(texelFetch(corners, first).x);
    int b = 2 * int(texelFetch(corners, first + 1).x);
    int c = 2 * int(texelFetch(corners, first + 2).x);
    vec3 A = texelFetch(vertices, a).xyz;
    vec3 edge1 = texelFetch(vertices, b).xyz - A;
    vec3 edge2 = texelFetch(vertices, c).xyz - A;
    vec3 ray = sampleRay(texel);
    vec2 uv = barycentrics(eye - A, ray, edge1, edge2);
    vec3 geometric = cross(edge1, edge2);
    vec3 N = unitOrZero((1.0 - uv.x - uv.y) * texelFetch(vertices, a + 1).xyz + uv.x * texelFetch(vertices, b + 1).xyz +
                        uv.y * texelFetch(vertices, c + 1).xyz);
    if (N == vec3(0.0))
        N = unitOrZero(geometric);
    surfaceNormal = vec4(dot(geometric, ray) > 0.0 ? -N : N, 0.0);
    surfacePosition = vec4(A + uv.x * edge1 + uv.y * edge2, 0.0);
}
