// A model that is black for viewers behind its surface: its own shade was compiled under another name.
#undef shade
vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return gate(dot(N, V), shadeAnyViewer(N, L, V, I)); }
