// Row sums and eigenvalues of colour matrices, against ones that are known.
#include "core/study/properties/matrix_facts.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace reflectance::test {
namespace {

using properties::matrixFacts;
using properties::MatrixFacts;

TEST(MatrixFacts, OfDiagonals)
{
    // Equal eigenvalues included: they are where a cubic's roots are hard.
    for (const auto& diagonal :
         {std::vector<double>{0.75, 0.5, 0.25}, {1, 1, 1}, {0, 0, 0}, {0.1, 0.1, 0.1}, {-0.5, 2, 0}}) {
        const MatrixFacts facts =
            matrixFacts(std::vector<double>{diagonal[0], 0, 0, 0, diagonal[1], 0, 0, 0, diagonal[2]});
        std::vector<double> expected = diagonal;
        std::sort(expected.begin(), expected.end(), [](double a, double b) { return std::fabs(a) > std::fabs(b); });
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(facts.rowSums[i], diagonal[i]);
            // A few roundings of numbers of size 1.
            EXPECT_NEAR(facts.eigenvalues[i].real(), expected[i], 1e-14);
            EXPECT_NEAR(facts.eigenvalues[i].imag(), 0.0, 1e-14);
        }
    }
}

TEST(MatrixFacts, OfAPermutationLieOnTheUnitCircle)
{
    const MatrixFacts facts = matrixFacts(std::vector<double>{0, 1, 0, 0, 0, 1, 1, 0, 0});
    for (const auto& z : facts.eigenvalues) {
        EXPECT_NEAR(std::abs(z), 1.0, 1e-14);
        EXPECT_NEAR(std::abs(z * z * z - 1.0), 0.0, 1e-14) << "a cube root of 1";
    }
    EXPECT_TRUE(facts.passive);
    EXPECT_EQ(facts.negativeEntries, 0);
}

/// Hazard H20: rows that cancel white light.
TEST(MatrixFacts, OfNegativeEntries)
{
    const MatrixFacts facts = matrixFacts(std::vector<double>{1, -1, 0, 0, 1, -1, -1, 0, 1});
    EXPECT_EQ(facts.negativeEntries, 3);
    EXPECT_FALSE(facts.passive);
    EXPECT_EQ(facts.rowSums[0], 0.0);
    EXPECT_NEAR(facts.spectralRadius, std::sqrt(3.0), 1e-14) << "1 - a cube root of 1";
}

/// Trace and determinant of a matrix with no zero, which any three eigenvalues must give back.
TEST(MatrixFacts, GiveTraceAndDeterminantBack)
{
    const std::vector<double> K{0.62, 0.05, 0.02, 0.06, 0.34, 0.03, 0.02, 0.05, 0.22};
    const MatrixFacts facts = matrixFacts(K);
    const auto sum = facts.eigenvalues[0] + facts.eigenvalues[1] + facts.eigenvalues[2];
    const auto product = facts.eigenvalues[0] * facts.eigenvalues[1] * facts.eigenvalues[2];
    EXPECT_NEAR(sum.real(), 0.62 + 0.34 + 0.22, 1e-14);
    EXPECT_NEAR(product.real(), 0.04474, 1e-14);
    EXPECT_NEAR(facts.rowSums[0], 0.69, 1e-15);
    EXPECT_TRUE(facts.passive);
}

TEST(MatrixFacts, ARowSumAboveOneIsNotPassive)
{
    EXPECT_TRUE(matrixFacts(std::vector<double>{0.5, 0.25, 0.25, 0, 0, 0, 0, 0, 0}).passive);
    EXPECT_FALSE(matrixFacts(std::vector<double>{0.5, 0.25, 0.26, 0, 0, 0, 0, 0, 0}).passive);
    EXPECT_FALSE(matrixFacts(std::vector<double>{0.5, -0.01, 0.25, 0, 0, 0, 0, 0, 0}).passive);
}

} // namespace
} // namespace reflectance::test
