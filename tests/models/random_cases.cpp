#include "tests/models/random_cases.h"

#include "core/math/lobe.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

namespace reflectance::test {
namespace {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    /// std distributions differ between libraries; this does not.
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    Vec3d direction()
    {
        const double z = uniform(-1.0, 1.0);
        const double azimuth = uniform(0.0, 2.0 * std::numbers::pi);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(azimuth), r * std::sin(azimuth), z};
    }
    Vec3d above(const Vec3d& N)
    {
        const Vec3d d = direction();
        return dot(N, d) < 0.0 ? -d : d;
    }

private:
    std::mt19937_64 engine_;
};

double randomExponent(Dice& dice, std::size_t row, double largest)
{
    if (row % 20 == 0)
        return 0.0;
    const double n = dice.logUniform(0.1, largest);
    return row % 2 == 0 ? std::round(n) : n;
}

std::vector<double> randomColor(Dice& dice, double largest)
{
    return {dice.uniform(0.0, largest), dice.uniform(0.0, largest), dice.uniform(0.0, largest)};
}

/// Both grazing; the azimuth undefined or nearly so.
void setCorners(Dice& dice, std::size_t row, OracleCase& c)
{
    constexpr double rightAngle = std::numbers::pi / 2;
    const double elevation = dice.logUniform(1e-12, 0.1);
    const double other = dice.logUniform(1e-12, 0.1);
    const double azimuth = dice.uniform(0.0, 2.0 * std::numbers::pi);
    // Beside each other, opposite, or anywhere between.
    const double apart = row % 3 == 0 ? dice.logUniform(1e-12, 1.0) : dice.uniform(0.0, 2.0 * std::numbers::pi);
    if (row % 8 == 3) {
        c.L = tilted(c.N, rightAngle - elevation, azimuth);
        c.V = tilted(c.N, rightAngle - other, azimuth + (row % 16 == 3 ? apart : std::numbers::pi + apart));
    } else if (row % 16 == 7) {
        c.V = row % 32 == 7 ? c.N : tilted(c.N, elevation, azimuth);
    } else if (row % 16 == 15) {
        c.L = row % 32 == 15 ? c.N : tilted(c.N, elevation, azimuth);
    }
}

void setDirections(Dice& dice, std::size_t row, OracleCase& c)
{
    constexpr double rightAngle = std::numbers::pi / 2;
    c.N = dice.direction();
    c.L = row % 10 == 0 ? dice.direction() : dice.above(c.N);
    // One throw per statement: the order of arguments is the compiler's choice.
    const double elevation = dice.logUniform(1e-12, 0.1);
    const double offset = dice.logUniform(1e-8, 1.6);
    const double azimuth = dice.uniform(0.0, 2.0 * std::numbers::pi);
    if (row % 4 == 1)
        c.L = tilted(c.N, rightAngle - elevation, azimuth);
    c.V = dice.above(c.N);
    if (row % 2 == 0)
        c.V = tilted(normalized(mirrored(c.N, c.L)), offset, azimuth);
    setCorners(dice, row, c);
    c.N = dice.logUniform(1e-200, 1e200) * c.N;
    c.L = dice.logUniform(1e-200, 1e200) * c.L;
    c.V = dice.logUniform(1e-200, 1e200) * c.V;
}

/// Every fourth row has 55 coefficients, the others 5; in every eighth one mode stands alone, so that nothing hides its
/// rounding.
void setModes(Dice& dice, std::size_t row, OracleCase& c)
{
    const bool isFine = row % 4 == 1;
    std::vector<double> coefficients(isFine ? 55 : 5);
    for (double& coefficient : coefficients)
        coefficient = dice.uniform(-1.0, 1.5);
    const auto alone = static_cast<std::size_t>(dice.uniform(0.0, static_cast<double>(coefficients.size())));
    for (std::size_t i = 0; row % 8 < 2 && i < coefficients.size(); ++i)
        coefficients[i] *= i == alone ? 1.0 : 0.0;
    c.parameters["order"] = {isFine ? 8.0 : 2.0};
    c.parameters["coefficients"] = coefficients;
}

} // namespace

Vec3d tilted(const Vec3d& v, double angle, double azimuth)
{
    const Vec3d helper = std::fabs(v.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d across = normalized(cross(v, helper));
    const Vec3d other = cross(v, across);
    return std::cos(angle) * v + std::sin(angle) * (std::cos(azimuth) * across + std::sin(azimuth) * other);
}

std::size_t rowsPerModel(std::size_t usual)
{
    const char* asked = std::getenv("REFLECTANCE_ORACLE_ROWS");
    return asked ? std::strtoul(asked, nullptr, 10) : usual;
}

std::vector<OracleCase> randomCases(const std::string& model, std::size_t count)
{
    Dice dice(20240607);
    std::vector<OracleCase> cases(count);
    for (std::size_t row = 0; row < count; ++row) {
        OracleCase& c = cases[row];
        c.model = model;
        setDirections(dice, row, c);
        c.I = {dice.logUniform(1e-3, 1e3), dice.logUniform(1e-3, 1e3), dice.logUniform(1e-3, 1e3)};
        c.radius = row % 5 == 0 ? 0.0 : dice.logUniform(1e-6, 90.0);
        std::vector<double> K(9);
        for (double& entry : K)
            entry = dice.uniform(-0.4, 1.0);
        c.parameters = {{"kd", {dice.uniform(0.0, 1.5)}},
                        {"reflectance", {dice.uniform(0.0, 1.5)}},
                        {"ks", randomColor(dice, 2.0)},
                        {"n", {randomExponent(dice, row, model.starts_with("blinn") ? 1e8 : 1e7)}},
                        {"K", K},
                        {"rho", randomColor(dice, 1.0)},
                        {"sigma", {row % 20 == 0 ? 0.0 : dice.logUniform(1e-3, 1e3)}},
                        {"r", {row % 20 < 2 ? static_cast<double>(row % 20) : dice.uniform(0.0, 1.0)}},
                        {"alpha", {dice.logUniform(1e-4, 1.0)}},
                        {"m", {dice.logUniform(1e-4, 10.0)}},
                        {"f0", randomColor(dice, 1.0)}};
        setModes(dice, row, c);
    }
    return cases;
}

} // namespace reflectance::test
