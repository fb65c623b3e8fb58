// The ray through a sample, linear in the sample's place: that of the picture's lower left corner, and its change per
// sample. Not of unit length.
uniform vec3 cornerRay;
uniform vec3 rayStepX;
uniform vec3 rayStepY;

vec3 sampleRay(ivec2 texel)
{
    return cornerRay + (float(texel.x) + 0.5) * rayStepX + (float(texel.y) + 0.5) * rayStepY;
}
