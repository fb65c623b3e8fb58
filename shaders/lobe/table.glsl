// The lobe from a table of equal steps in s = sqrt(1 - R.V) = |R - V| / sqrt(2), where a lobe of any width is as smooth as
// a bell; its C++ twin is core/reflectance/lobe_table.h, which fills the table too.
uniform float lobeTable[257];
uniform float lobeTableScale; // steps per unit of s

float lobe(vec3 R, vec3 V, float n)
{
    vec3 chord = R - V;
    float place = min(sqrt(0.5 * dot(chord, chord)) * lobeTableScale, 255.999);
    int first = int(place);
    float share = place - float(first);
    return gate(dot(R, V), lobeTable[first] * (1.0 - share) + lobeTable[first + 1] * share);
}
