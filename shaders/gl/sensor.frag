// The third stage: linear radiance to 8-bit code values. The encoding is done here, not by GL_FRAMEBUFFER_SRGB, which is
// up to one code off; the rounding too, for GL may round ties either way.
uniform sampler2D linearPicture;

layout(location = 0) out vec4 code;

void main()
{
    ivec2 size = textureSize(linearPicture, 0);
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec3 developed = develop(texelFetch(linearPicture, place, 0).xyz, place.x, size.y - 1 - place.y, size.x, size.y);
    code = vec4(floor(255.0 * developed + 0.5) / 255.0, 1.0);
}
