//! name      Oren-Nayar, full
//! family    Rough and matte
//! formula   rho I (N.L) (C1 + cos(phi) C2 tan(beta) + (1 - |cos(phi)|) C3 tan((alpha + beta) / 2)) + 0.17 rho^2 I (N.L) (1 - cos(phi) (2 beta / pi)^2) sigma^2 / (sigma^2 + 0.13),  alpha and beta the larger and the smaller angle to N, phi the azimuth between L and V
//! citation  Oren and Nayar, Generalization of Lambert's reflectance model, SIGGRAPH 1994: the long form, with interreflection
//! about     The long form of Oren-Nayar, with the light that bounces once between the walls of a groove; it deepens the colour, since rho enters squared. A fit to integrals, taken as it stands: for sigma above 0.65 it is negative where light and viewer graze opposite sides. Nothing is clamped before the sensor, which counts such pixels.
//! reciprocal yes
//! passive   no: smooth surfaces return up to 5 % more than arrives from grazing light
//! becomes   lambert where rho=kd;sigma=0
//! nonnegative no: the fitted formula falls below 0 for sigma above 0.65, light and viewer grazing from opposite sides

uniform vec3 rho = vec3(0.69, 0.43, 0.29);
//: like     oren_nayar

uniform float sigma = 0.4;
//: like     oren_nayar

// pi/2 less an angle whose cosine is given too: from the cosine where the angle is above 45 degrees, so that no digit is
// lost at the horizon.
float elevation(float angle, float cosine)
{
    return max(arcsine(clamp(cosine, 0.0, 0.70710678)), gate(cosine - 0.7, 1.5707963267948966 - angle));
}

// The bracket of C1, C2 and C3. tan(beta) is never formed, and no difference near 0 is: on opposite sides, both grazing,
// the terms nearly cancel, and what is left must not be rounding.
float direct(float variance, vec3 planeL, vec3 planeV, float sinL, float sinV, float li, float lv, float alpha, float beta)
{
    float sinAlpha = max(max(sinL, sinV), 1e-30);
    float cosAlpha = min(li, lv);
    float cosBeta = max(li, lv);
    float growth = variance / (variance + 0.09);
    // cos(phi) sin(alpha) tan(beta) is s / cos(beta); for phi beyond a right angle times (sin(alpha) - x^3) / sin(alpha),
    // x = 2 beta / pi = 1 - y.
    float s = sinL * sinV * dot(planeL, planeV);
    float y = 0.63661977236758134 * elevation(beta, cosBeta);
    float behind = (y * (3.0 - 3.0 * y + y * y) - cosAlpha * cosAlpha / (1.0 + sinAlpha)) / sinAlpha;
    float C2 = 0.45 * growth * (max(s, 0.0) + min(s, 0.0) * behind) / cosBeta;
    // 1 - |cos(phi)|, and the tangent of the half sum as (sin + sin) / (cos + cos).
    vec3 apart = planeL - planeV;
    vec3 sum = planeL + planeV;
    float bent = 0.40528473456935109 * alpha * beta; // 4 alpha beta / pi^2
    float C3 = 0.125 * growth * bent * bent * 0.5 * min(dot(apart, apart), dot(sum, sum));
    return 1.0 - 0.5 * variance / (variance + 0.33) + C2 + C3 * (sinL + sinV) / (li + lv);
}

vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)
{
    float li = dot(N, L);
    float lv = dot(N, V);
    vec3 acrossL = cross(N, L);
    vec3 acrossV = cross(N, V);
    float sinL = sqrt(dot(acrossL, acrossL));
    float sinV = sqrt(dot(acrossV, acrossV));
    // Normals of the planes of N and L, N and V: phi is the angle between them. Where L or V stands at N there is none;
    // its terms are 0 there whatever it is.
    vec3 planeL = acrossL / max(sinL, 1e-30);
    vec3 planeV = acrossV / max(sinV, 1e-30);
    float angleL = angleBetween(N, L);
    float angleV = angleBetween(N, V);
    float alpha = max(angleL, angleV);
    float beta = min(angleL, angleV);
    float slope = min(sigma, 1e9); // see oren_nayar
    float variance = slope * slope;
    float first = direct(variance, planeL, planeV, sinL, sinV, li, lv, alpha, beta);
    float shadow = 0.63661977236758134 * beta; // 2 beta / pi
    float second = 0.17 * variance / (variance + 0.13) * (1.0 - dot(planeL, planeV) * shadow * shadow);
    return gate(min(li, lv), li * (first * rho + second * (rho * rho)) * I);
}
