// The table of a surface for which none was measured.
vec3 tableAt(vec3 N, vec3 L, vec3 V, vec3 I) { return vec3(0.0); }
