// What model texts may call, in GLSL 3.30: the same functions with the same policies as core/math/lobe.h,
// core/math/directions.h and core/reflectance/frame.h. The names in this file are reserved; no model may define or
// shadow them.
//
// `lobe` itself stands in lobe/, a file per form of it. GLSL's pow is never used but by the form that is named after it:
// on llvmpipe it is 1 % wrong at n = 1e5, 10 % at 1e6 and 94 % at 1e7, and exp and log are only good to 15 units in the
// last place. What follows is as good as its rounded inputs allow.

float lightDisc = 0.0; // (2 sin(a/2))^2 of the light's angular radius a; the frame sets it for each light

vec3 environment(vec3 direction); // the radiance from a unit direction; the frame defines it

// value where condition > 0, else 0: the open gate of N.L > 0.
float gate(float condition, float value) { return condition > 0.0 ? value : 0.0; }
vec3 gate(float condition, vec3 value) { return condition > 0.0 ? value : vec3(0.0); }

// 2N(N.A) - A: A mirrored about N.
vec3 mirrored(vec3 N, vec3 A) { return (2.0 * dot(N, A)) * N - A; }

// 1 where V lies inside the light's disc about R, else 0. The disc is open: radius 0 contains nothing.
float insideLight(vec3 R, vec3 V)
{
    vec3 chord = R - V;
    return gate(lightDisc - dot(chord, chord), 1.0);
}

// exp(y) for y <= 0; 0 where the result would leave the normal numbers: denormals are slow, and GPUs differ on them.
// y = k log 2 + r with |r| <= log(2)/2; log 2 is split so that k times its head is exact. The Taylor sum of degree 7
// ends below 2^-27.
float expOrZero(float y)
{
    if (!(y > -87.3265)) // log of the smallest normal number, plus 0.01
        return 0.0;
    float k = floor(y * 1.44269504 + 0.5);
    float r = (y - k * 0.693359375) + k * 2.12194440e-4;
    float sum = 1.0 + r * (1.0 + r * (1.0 / 2.0 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 +
                r * (1.0 / 720.0 + r * (1.0 / 5040.0)))))));
    return sum * intBitsToFloat((int(k) + 127) << 23);
}

// asin(x) for 0 <= x <= sqrt(1/2): x (1 + t Q(t)), t = x^2, with Q the polynomial that meets (asin(x) / x - 1) / t at the
// eight Chebyshev points of 0 .. 1/2. Off by at most 2^-26 of the result; llvmpipe's acos is 1.6e-4 off, its atan 2e-5.
float arcsine(float x)
{
    float t = x * x;
    float Q = 0.1666666568 + t * (0.07500252164 + t * (0.04453881397 + t * (0.03199023923 + t * (0.01043532597 +
              t * (0.06379697639 + t * (-0.07972071596 + t * 0.0946973496))))));
    return x + x * (t * Q);
}

// The angle between unit vectors, in radians: 2 asin(|A - B| / 2), and pi less that of A and -B beyond a right angle.
float angleBetween(vec3 A, vec3 B)
{
    vec3 apart = A - B;
    vec3 sum = A + B;
    float toB = dot(apart, apart);
    float toOpposite = dot(sum, sum);
    float halfAngle = arcsine(0.5 * sqrt(min(toB, toOpposite)));
    return 2.0 * halfAngle + gate(toB - toOpposite, 3.14159265 - 4.0 * halfAngle);
}

// The unit vector half way between unit vectors, (0,0,0) where L = -V; square on L - V whatever their rounded lengths,
// and scaled before it is squared.
vec3 halfway(vec3 L, vec3 V)
{
    vec3 apart = L - V;
    vec3 rough = L + V;
    vec3 sum = rough - (dot(rough, apart) / max(dot(apart, apart), 2.0)) * apart;
    float largest = max(max(abs(sum.x), abs(sum.y)), abs(sum.z));
    vec3 scaled = sum * (1.0 / max(largest, 1.17549435e-38));
    return scaled / sqrt(max(dot(scaled, scaled), 1.0));
}
