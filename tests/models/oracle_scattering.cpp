// Koenderink, van Doorn and Stavridi's modes from their definition: Zernike polynomials by factorials, over angles.
#include "tests/models/oracle_math.h"

namespace reflectance::test {
namespace {

long factorial(int n)
{
    return n < 2 ? 1 : n * factorial(n - 1);
}

/// R_n^l(r), Born and Wolf's sum; `powers` holds 1, r, r^2, ...
Real zernike(int n, int l, const std::vector<Real>& powers)
{
    Real sum = 0;
    for (int s = 0; s <= (n - l) / 2; ++s) {
        const long whole = factorial(n - s) / (factorial(s) * factorial((n + l) / 2 - s) * factorial((n - l) / 2 - s));
        sum += (s % 2 == 0 ? whole : -whole) * powers[static_cast<std::size_t>(n - 2 * s)];
    }
    return sum;
}

/// sqrt(n+1) R_n^l of the light and of the viewer.
struct Radial {
    int n;
    Real light, viewer;
};

std::vector<Radial> radials(int l, int order, const std::vector<Real>& light, const std::vector<Real>& viewer)
{
    std::vector<Radial> all;
    for (int n = l; n <= order; n += 2) {
        const Real norm = sqrt(Real(n + 1));
        all.push_back({n, norm * zernike(n, l, light), norm * zernike(n, l, viewer)});
    }
    return all;
}

std::vector<Real> powersOf(const Real& r)
{
    std::vector<Real> powers{1};
    while (powers.size() < 9)
        powers.push_back(powers.back() * r);
    return powers;
}

/// The modes times pi, in the order of the coefficients; `d` holds N, L and V.
std::vector<Real> modes(const std::vector<Real>& d, int order)
{
    const Three N = three(d, atN);
    const Three planeL = cross(N, three(d, atL));
    const Three planeV = cross(N, three(d, atV));
    const bool isAtPole = dot(planeL, planeL) == 0 || dot(planeV, planeV) == 0;
    const Real azimuth = isAtPole ? Real(0) : angle(planeL, planeV);
    const Real root = sqrt(Real(2));
    const auto light = powersOf(root * sin(angle(N, three(d, atL)) / 2));
    const auto viewer = powersOf(root * sin(angle(N, three(d, atV)) / 2));
    std::vector<Real> all;
    for (int l = 0; l <= order; ++l) {
        const Real ripple = l == 0 ? Real(1) : Real(root * cos(l * azimuth));
        const auto degrees = radials(l, order, light, viewer);
        for (const Radial& n : degrees)
            for (const Radial& m : degrees) {
                if (m.n > n.n)
                    break;
                const Real crossed = (n.light * m.viewer + m.light * n.viewer) / root;
                all.push_back((n.n == m.n ? Real(n.light * n.viewer) : crossed) * ripple / 2);
            }
    }
    return all;
}

/// Coefficients are moved one by one to see what they weigh: the modes stay as long as the directions do.
const std::vector<Real>& keptModes(const Inputs& x, int order)
{
    thread_local std::map<std::pair<int, std::vector<Real>>, std::vector<Real>> kept;
    std::vector<Real> directions(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(atI));
    auto found = kept.find({order, directions});
    if (found == kept.end()) {
        if (kept.size() > 32)
            kept.clear();
        found = kept.emplace(std::pair(order, directions), modes(directions, order)).first;
    }
    return found->second;
}

Three koenderink(const Inputs& x)
{
    if (!above(x, atL) || !above(x, atV))
        return {};
    const std::vector<Real>& all = keptModes(x, x.size() - atParameters - 1 == 5 ? 2 : 8);
    Real value = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        value += x[atParameters + 1 + i] * all[i];
    return scaled(three(x, atI), cosineOfIncidence(x) * value);
}

} // namespace

Formulas scatteringFormulas()
{
    // A table without a measurement is black.
    return {{"koenderink", {{{"order"}, {"coefficients", 0}}, koenderink}},
            {"table", {{}, [](const Inputs&) { return Three{}; }}}};
}

} // namespace reflectance::test
