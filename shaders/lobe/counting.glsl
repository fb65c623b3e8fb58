// What the forms of the lobe ask of an exponent, which is the same for every direction: whole numbers to count by. The
// C++ twins are core/math/counting.h.

int wholeNumber(float n) { return int(n + 0.5); }

// The power of two nearest to n in ratio, at most 16, as the number of squarings that reach it.
int squaringsFor(float n)
{
    return n < 1.41421356 ? 0 : n < 2.82842712 ? 1 : n < 5.65685425 ? 2 : n < 11.3137085 ? 3 : 4;
}
