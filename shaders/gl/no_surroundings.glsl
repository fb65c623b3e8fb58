// The environment of a scene that has none.
vec3 environment(vec3 direction) { return vec3(0.0); }
