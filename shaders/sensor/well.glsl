// The full well: a pixel holds no more. NaN passes, since it compares with nothing.

uniform int wellOn = 1;
uniform float wellLimit = 1.0;

float collected(float light)
{
    return wellOn == 1 && light > wellLimit ? wellLimit : light;
}
