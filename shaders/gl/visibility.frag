// Says which triangle each sample sees: 1 + its number, 0 where nothing was hit. Where on it is for surface.frag.
layout(location = 0) out uint seen;

void main()
{
    seen = uint(gl_PrimitiveID) + 1u;
}
