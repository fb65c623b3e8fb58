// Places the mesh in the picture. The matrix was multiplied in double and rounded once.
uniform mat4 clipFromWorld;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 surfacePosition;
out vec3 surfaceNormal;

void main()
{
    surfacePosition = position;
    surfaceNormal = normal;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
