vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    return kd * I;
}
