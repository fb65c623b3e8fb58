// White balance and colour matrix, multiplied outside: one row for each channel that comes out.

uniform int balanceOn = 0;
uniform vec3 balanceRed = vec3(1.0, 0.0, 0.0);
uniform vec3 balanceGreen = vec3(0.0, 1.0, 0.0);
uniform vec3 balanceBlue = vec3(0.0, 0.0, 1.0);

vec3 balanced(vec3 light)
{
    if (balanceOn == 0)
        return light;
    return vec3(dot(balanceRed, light), dot(balanceGreen, light), dot(balanceBlue, light));
}
