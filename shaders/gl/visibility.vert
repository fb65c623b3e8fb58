// Places the mesh in the picture. The matrix was multiplied in double and rounded once.
uniform mat4 clipFromWorld;

layout(location = 0) in vec3 position;

void main()
{
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
