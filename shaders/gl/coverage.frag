// Keeps the pixels of which a sample sees something: their depth is written, and shading runs nowhere else.
uniform usampler2D triangles; // 1 + the number of the triangle that a sample sees, 0: none
uniform int samplesPerAxis;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samplesPerAxis;
    uint seen = 0u;
    ivec2 at = ivec2(0);
    do {
        seen |= texelFetch(triangles, first + at, 0).x;
        at.x += 1;
        if (at.x == samplesPerAxis)
            at = ivec2(0, at.y + 1);
    } while (at.y < samplesPerAxis);
    if (seen == 0u)
        discard;
}
