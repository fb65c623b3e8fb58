// Keeps the pixels of which a sample sees something: their depth is written, and shading runs nowhere else.
uniform sampler2D normals; // N, hit flag
uniform int samplesPerAxis;

layout(location = 0) out vec4 nothing;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samplesPerAxis;
    float hits = 0.0;
    ivec2 at = ivec2(0);
    do {
        hits += texelFetch(normals, first + at, 0).w;
        at.x += 1;
        if (at.x == samplesPerAxis)
            at = ivec2(0, at.y + 1);
    } while (at.y < samplesPerAxis);
    if (hits == 0.0)
        discard;
    nothing = vec4(0.0);
}
