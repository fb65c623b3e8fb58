// The third stage: linear radiance to 8-bit code values. The encoding is done here, not by GL_FRAMEBUFFER_SRGB, which is
// up to one code off; the rounding too, for GL may round ties either way.
uniform sampler2D linearPicture;

layout(location = 0) out vec4 code;

void main()
{
    vec3 encoded = develop(texelFetch(linearPicture, ivec2(gl_FragCoord.xy), 0).xyz);
    code = vec4(floor(255.0 * encoded + 0.5) / 255.0, 1.0);
}
