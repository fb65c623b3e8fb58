// The model at given directions, one (row, light) pair per texel: GLSL's side of `eval`.
uniform sampler2D rowNormals;
uniform sampler2D rowViewers;
uniform sampler2D rowLights;
uniform sampler2D rowIntensities; // I, disc

layout(location = 0) out vec4 value;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 intensity = texelFetch(rowIntensities, texel, 0);
    lightDisc = intensity.w;
    value = vec4(shade(texelFetch(rowNormals, texel, 0).xyz, texelFetch(rowLights, texel, 0).xyz,
                       texelFetch(rowViewers, texel, 0).xyz, intensity.xyz), 1.0);
}
