#include "app/explorer/ui/matrix_modes.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {

namespace {

constexpr std::array<const char*, 3> channels = {"red", "green", "blue"};

double meanOfDiagonal(const MatrixValues& K)
{
    // Three equal numbers are their mean, which the rounded sum may miss by a bit.
    return K[0] == K[4] && K[4] == K[8] ? K[0] : (K[0] + K[4] + K[8]) / 3.0;
}

MatrixValues diagonal(double red, double green, double blue)
{
    return {red, 0, 0, 0, green, 0, 0, 0, blue};
}

/// From one number back to three: the remembered proportions, at the present mean.
MatrixValues unfolded(double mean, const MatrixValues& wider)
{
    const double before = meanOfDiagonal(wider);
    if (before == 0.0)
        return diagonal(mean, mean, mean);
    const double factor = mean / before; // exactly 1 where the mean was left alone
    return diagonal(factor * wider[0], factor * wider[4], factor * wider[8]);
}

MatrixValues withOffDiagonals(MatrixValues K, const MatrixValues& from)
{
    for (std::size_t i = 0; i < 9; ++i)
        if (i % 4 != 0)
            K[i] = from[i];
    return K;
}

MatrixValues narrowed(const MatrixValues& K, MatrixMode mode)
{
    if (mode == MatrixMode::Diagonal)
        return diagonal(K[0], K[4], K[8]);
    const double mean = meanOfDiagonal(K);
    return diagonal(mean, mean, mean);
}

} // namespace

MatrixMode narrowestMode(const MatrixValues& K)
{
    if (K[1] != 0.0 || K[2] != 0.0 || K[3] != 0.0 || K[5] != 0.0 || K[6] != 0.0 || K[7] != 0.0)
        return MatrixMode::Full;
    return K[0] == K[4] && K[4] == K[8] ? MatrixMode::Scalar : MatrixMode::Diagonal;
}

MatrixMode modeOf(const MatrixValues& K, const MatrixMemory& memory)
{
    return std::max(narrowestMode(K), memory.picked.value_or(MatrixMode::Scalar));
}

MatrixValues switched(const MatrixValues& K, MatrixMode mode, MatrixMemory& memory)
{
    const MatrixMode before = modeOf(K, memory);
    memory.picked = mode;
    if (mode < before) {
        // Full to Diagonal to Scalar: the off-diagonals were remembered at the first step.
        memory.wider = memory.wider && before == MatrixMode::Diagonal ? withOffDiagonals(K, *memory.wider) : K;
        return narrowed(K, mode);
    }
    if (mode == before || !memory.wider)
        return K;
    MatrixValues wide = before == MatrixMode::Scalar ? unfolded(K[0], *memory.wider) : K;
    return mode == MatrixMode::Full ? withOffDiagonals(wide, *memory.wider) : wide;
}

double offDiagonalShare(const MatrixValues& K)
{
    const double onDiagonal = std::abs(K[0]) + std::abs(K[4]) + std::abs(K[8]);
    double all = 0.0;
    for (const double k : K)
        all += std::abs(k);
    return onDiagonal > 0.0 ? (all - onDiagonal) / onDiagonal : 0.0;
}

std::vector<std::string> matrixRemarks(const MatrixValues& K)
{
    std::vector<std::string> remarks;
    for (std::size_t row = 0; row < 3; ++row) {
        const double sum = K[3 * row] + K[3 * row + 1] + K[3 * row + 2];
        if (sum > 1.0)
            remarks.push_back("Not passive: under white light the " + std::string(channels[row]) + " sensor gets " +
                              general(sum, 4) + " times what a perfect white diffuser gives.");
    }
    if (std::any_of(K.begin(), K.end(), [](double k) { return k < 0.0; }))
        remarks.push_back(
            "A negative entry is legal: it takes light of one primary away from a sensor, as a colour transform does. "
            "Pixels may become negative; the sensor counts them.");
    return remarks;
}

} // namespace reflectance::explorer
