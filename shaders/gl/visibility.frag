// Keeps what each sample sees: N (turned to the viewer's side) and P, and the triangle's number in the two spare
// channels. It is split into two whole numbers below 2^16: floats hold those exactly, while an integer's bits read as a
// float would be a denormal, which a GPU may flush to 0.
in vec3 surfacePosition;
in vec3 surfaceNormal;

layout(location = 0) out vec4 normalAndHit;   // w: 1 + triangle mod 65536; 0 where nothing was hit
layout(location = 1) out vec4 positionAndTag; // w: triangle / 65536

void main()
{
    // The largest component is divided out first: opposed vertex normals may all but cancel between corners.
    float largest = max(abs(surfaceNormal.x), max(abs(surfaceNormal.y), abs(surfaceNormal.z)));
    vec3 N = largest > 0.0 ? normalize(surfaceNormal / largest) : vec3(0.0);
    normalAndHit = vec4(gl_FrontFacing ? N : -N, float(1 + (gl_PrimitiveID & 0xFFFF)));
    positionAndTag = vec4(surfacePosition, float(gl_PrimitiveID >> 16));
}
