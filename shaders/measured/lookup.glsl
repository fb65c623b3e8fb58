// A measured table, looked up between its samples: the same policies as core/measured/table.h, whose double evaluation is
// the truth that tests hold this text against. Texels: the angles of the first, second and third axis (x), then the
// samples, `tableRows` texels each (three numbers, and 1 where measured or 0 in a hole).
uniform samplerBuffer tableTexels;
uniform int tableSystem = 0;        // as AngleSystem: (theta_i, theta_r), with delta_phi, half and difference angles
uniform int tableInterpolation = 0; // as Interpolation: nearest, linear, monotone cubic
uniform int tableRows = 1;          // 3 where a sample is a matrix
uniform bool tableIsMatrix = false;
uniform int tableCountA = 1;
uniform int tableCountB = 1;
uniform int tableCountC = 1;

float tableHoles = 0.0; // how often a lit and visible point fell into a hole

// arctan(y/x) in 0 .. pi for y >= 0, 0 where both are 0. GLSL's atan is 2e-5 off on software rasterisers. The series ends
// below 2^-24 for |t| <= tan(pi/8).
float angleOf(float y, float x)
{
    float large = max(y, abs(x));
    if (!(large > 0.0))
        return 0.0;
    float t = min(y, abs(x)) / large;
    bool folds = t > 0.41421356237309503;
    t = folds ? (t - 1.0) / (t + 1.0) : t;
    float s = t * t;
    float series = t * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s * (1.0 / 9.0 -
                   s * (1.0 / 11.0 - s * (1.0 / 13.0 - s * (1.0 / 15.0))))))));
    float a = folds ? series + 0.7853981633974483 : series;
    a = y > abs(x) ? 1.5707963267948966 - a : a;
    return x < 0.0 ? 3.141592653589793 - a : a;
}

float polarAngle(vec3 N, vec3 A)
{
    vec3 across = cross(N, A);
    return angleOf(sqrt(dot(across, across)), dot(N, A));
}

float axisAt(int i) { return texelFetch(tableTexels, i).x; }

// Of -pi .. pi, into the range of an azimuth axis that ends at `last`: mirror-symmetric tables list it up to pi.
float foldedAzimuth(float y, float x, float last)
{
    float azimuth = angleOf(abs(y), x);
    return y < 0.0 && last > 3.1415927 ? 6.283185307179586 - azimuth : azimuth;
}

// The three angles; unit vectors.
vec3 tableAngles(vec3 N, vec3 L, vec3 V)
{
    if (tableSystem < 2) {
        vec3 acrossL = L - dot(N, L) * N;
        vec3 acrossV = V - dot(N, V) * N;
        float last = axisAt(tableCountA + tableCountB + tableCountC - 1);
        float azimuth = tableSystem == 0 ? 0.0 : foldedAzimuth(dot(N, cross(L, V)), dot(acrossL, acrossV), last);
        return vec3(polarAngle(N, L), polarAngle(N, V), azimuth);
    }
    vec3 sum = L + V;
    float whole = sqrt(dot(sum, sum));
    vec3 H = sum / whole;
    vec3 apart = L - V;
    // The azimuth of L about H, from the direction in which H leans away from N.
    float y = dot(L, cross(N, H));
    float x = dot(L, dot(N, H) * H - N);
    float azimuth = angleOf(abs(y), x);
    return vec3(polarAngle(N, H), angleOf(sqrt(dot(apart, apart)), whole), y < 0.0 ? 3.141592653589793 - azimuth : azimuth);
}

// Number of the sample at or below an angle, on the axis of `count` samples that begins at texel `first`.
int sampleBelow(int first, int count, float angle)
{
    int low = 0;
    int high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (angle < axisAt(first + middle))
            high = middle;
        else
            low = middle;
    }
    return low;
}

// How far an angle lies beyond the sample below it, 0 .. 1 of the way to the next; -1 outside the axis. Angles up to 2e-6 rad
// outside count as its rim, what rounding of directions to float can miss.
float shareAbove(int first, int count, int below, float angle)
{
    float start = axisAt(first);
    float end = axisAt(first + count - 1);
    if (!(angle >= start - 2e-6 && angle <= end + 2e-6))
        return -1.0;
    if (below + 1 == count || !(angle > start))
        return 0.0;
    float here = axisAt(first + below);
    return (angle - here) / (axisAt(first + below + 1) - here);
}

// The weighted harmonic mean of Fritsch and Butland 1984: slope between two intervals.
float slopeBetween(float h0, float d0, float h1, float d1)
{
    if (!(d0 * d1 > 0.0))
        return 0.0;
    float w0 = h0 + 2.0 * h1;
    float w1 = 2.0 * h0 + h1;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

// Without curvature, kept where Fritsch and Carlson 1980 prove monotony.
float slopeAtEnd(float d, float other)
{
    float natural = 0.5 * (3.0 * d - other);
    if (natural * d <= 0.0)
        return 0.0;
    return d > 0.0 ? min(natural, 3.0 * d) : max(natural, 3.0 * d);
}

// One number between a and b; `first` is the texel of a's angle. A neighbour without weight is not there.
float cubicNumber(float before, float hasBefore, float a, float b, float after, float hasAfter, int first, float t)
{
    float x1 = axisAt(first);
    float x2 = axisAt(first + 1);
    float h = x2 - x1;
    float d = (b - a) / h;
    float slopeA = d;
    float slopeB = d;
    if (hasBefore == 1.0) {
        float h0 = x1 - axisAt(first - 1);
        slopeA = slopeBetween(h0, (a - before) / h0, h, d);
    }
    if (hasAfter == 1.0) {
        float h1 = axisAt(first + 2) - x2;
        slopeB = slopeBetween(h, d, h1, (after - b) / h1);
    }
    if (hasBefore != 1.0)
        slopeA = slopeAtEnd(d, slopeB);
    if (hasAfter != 1.0)
        slopeB = slopeAtEnd(d, slopeA);
    float s = 1.0 - t;
    return a + (b - a) * t * t * (3.0 - 2.0 * t) + h * t * s * (s * slopeA - t * slopeB);
}

vec4 cubic(vec4 before, vec4 a, vec4 b, vec4 after, int first, float t)
{
    return vec4(cubicNumber(before.x, before.w, a.x, b.x, after.x, after.w, first, t),
                cubicNumber(before.y, before.w, a.y, b.y, after.y, after.w, first, t),
                cubicNumber(before.z, before.w, a.z, b.z, after.z, after.w, first, t), 1.0);
}

// Holes take no part: what is left is weighted anew.
vec4 linear(vec4 a, vec4 b, float t)
{
    float fromB = t * b.w;
    float weight = a.w == 1.0 && b.w == 1.0 ? 1.0 : (1.0 - t) * a.w + fromB;
    if (!(weight > 0.0))
        return vec4(0.0, 0.0, 0.0, 0.0);
    float share = fromB / weight;
    return vec4(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z), weight);
}

// Whether an axis is looked at in one place, two, or four. Each place is asked for in one line of the text only: a driver
// copies a function's body to each of its calls, and compiles the more slowly.
bool isOnePlace(float t) { return t == 0.0 || tableInterpolation == 0; }
int nearest(int i, float t) { return tableInterpolation == 0 && t >= 0.5 ? i + 1 : i; }
bool isCubic(vec4 a, vec4 b) { return tableInterpolation == 2 && a.w == 1.0 && b.w == 1.0; }

vec4 tableSample(int index, int row)
{
    return texelFetch(tableTexels, tableCountA + tableCountB + tableCountC + index * tableRows + row);
}

vec4 alongC(int first, int row, int i, float t)
{
    int at = first * tableCountC + nearest(i, t);
    vec4 a = tableSample(at, row);
    if (isOnePlace(t))
        return a;
    vec4 b = tableSample(at + 1, row);
    if (!isCubic(a, b))
        return linear(a, b, t);
    vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 before = none;
    vec4 after = none;
    if (i > 0)
        before = tableSample(at - 1, row);
    if (i + 2 < tableCountC)
        after = tableSample(at + 2, row);
    return cubic(before, a, b, after, tableCountA + tableCountB + i, t);
}

vec4 alongB(int first, int row, int i, float t, int c, float tC)
{
    int at = first * tableCountB + nearest(i, t);
    vec4 a = alongC(at, row, c, tC);
    if (isOnePlace(t))
        return a;
    vec4 b = alongC(at + 1, row, c, tC);
    if (!isCubic(a, b))
        return linear(a, b, t);
    vec4 before = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 after = before;
    if (i > 0)
        before = alongC(at - 1, row, c, tC);
    if (i + 2 < tableCountB)
        after = alongC(at + 2, row, c, tC);
    return cubic(before, a, b, after, tableCountA + i, t);
}

vec4 alongA(int row, int i, float t, int b, float tB, int c, float tC)
{
    vec4 here = alongB(nearest(i, t), row, b, tB, c, tC);
    if (isOnePlace(t))
        return here;
    vec4 next = alongB(i + 1, row, b, tB, c, tC);
    if (!isCubic(here, next))
        return linear(here, next, t);
    vec4 before = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 after = before;
    if (i > 0)
        before = alongB(i - 1, row, b, tB, c, tC);
    if (i + 2 < tableCountA)
        after = alongB(i + 2, row, b, tB, c, tC);
    return cubic(before, here, next, after, i, t);
}

vec3 inHole()
{
    tableHoles += 1.0;
    return vec3(0.0);
}

// f(L, V) I in 1/sr; 0 in a hole, and where light or viewer is not above the surface.
vec3 tableAt(vec3 N, vec3 L, vec3 V, vec3 I)
{
    if (!(dot(N, L) > 0.0) || !(dot(N, V) > 0.0))
        return vec3(0.0);
    vec3 angles = tableAngles(N, L, V);
    int startC = tableCountA + tableCountB;
    int a = sampleBelow(0, tableCountA, angles.x);
    int b = sampleBelow(tableCountA, tableCountB, angles.y);
    int c = tableSystem == 0 ? 0 : sampleBelow(startC, tableCountC, angles.z);
    float tA = shareAbove(0, tableCountA, a, angles.x);
    float tB = shareAbove(tableCountA, tableCountB, b, angles.y);
    float tC = tableSystem == 0 ? 0.0 : shareAbove(startC, tableCountC, c, angles.z);
    if (min(tA, min(tB, tC)) < 0.0)
        return inHole();
    vec3 seen = vec3(0.0);
    for (int row = 0; row < tableRows; ++row) {
        vec4 found = alongA(row, a, tA, b, tB, c, tC);
        if (found.w < 0.5)
            return inHole();
        vec3 f = vec3(found.x, found.y, found.z);
        if (!tableIsMatrix)
            return f * I;
        float sum = dot(f, I);
        if (row == 0)
            seen.x = sum;
        else if (row == 1)
            seen.y = sum;
        else
            seen.z = sum;
    }
    return seen;
}
