// The environment as core/illumination/environment.h describes it: a picture, one colour, or the studio.
uniform vec3 environmentFactor;
uniform vec2 environmentTurn; // cosine and sine of its rotation about the y axis
#ifndef ENVIRONMENT_MAP
uniform bool environmentIsConstant;
#endif

vec3 environment(vec3 direction)
{
    vec3 d = vec3(environmentTurn.x * direction.x - environmentTurn.y * direction.z, direction.y,
                  environmentTurn.y * direction.x + environmentTurn.x * direction.z);
#ifdef ENVIRONMENT_MAP
    return environmentFactor * mapRadiance(d);
#else
    return environmentIsConstant ? environmentFactor : environmentFactor * studioRadiance(d);
#endif
}
