// Lights, and what of them arrives at a point. Two texels per light:
// (direction or position, 1 for a point light), (I, disc). Directions were normalised in double.
uniform samplerBuffer lightTexels;

vec3 L; // unit, to the light
vec3 I; // as it arrives

const float smallestLightDistance = 1e-6; // as core/illumination/light.h: 1/r^2 stops growing here

void arriveFromPoint(vec3 position, vec3 intensity, vec3 P)
{
    vec3 toLight = position - P;
    float largest = max(abs(toLight.x), max(abs(toLight.y), abs(toLight.z)));
    if (!(largest > 0.0)) {
        L = vec3(0.0);
        I = vec3(0.0);
        return;
    }
    vec3 scaled = toLight / largest; // neither 1e-23 nor 1e23 survives being squared
    float stretch = length(scaled);
    float r = max(largest * stretch, smallestLightDistance);
    L = scaled / stretch;
    I = intensity / r / r;
}

// Sets L, I and lightDisc.
void arrive(int light, vec3 P)
{
    vec4 place = texelFetch(lightTexels, 2 * light);
    vec4 strength = texelFetch(lightTexels, 2 * light + 1);
    lightDisc = strength.w;
#if defined(POINT_LIGHTS) && defined(DIRECTIONAL_LIGHTS)
    if (place.w > 0.0) {
        arriveFromPoint(place.xyz, strength.xyz, P);
        return;
    }
#elif defined(POINT_LIGHTS)
    arriveFromPoint(place.xyz, strength.xyz, P);
    return;
#endif
    L = place.xyz;
    I = strength.xyz;
}
