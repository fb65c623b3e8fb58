// Narrowing a colour matrix and widening it again loses nothing.
#include "app/explorer/ui/matrix_modes.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

const MatrixValues clay = {0.62, 0.05, 0.02, 0.06, 0.34, 0.03, 0.02, 0.05, 0.22};

TEST(MatrixModes, FollowFromTheValues)
{
    EXPECT_EQ(narrowestMode(clay), MatrixMode::Full);
    EXPECT_EQ(narrowestMode({0.6, 0, 0, 0, 0.3, 0, 0, 0, 0.2}), MatrixMode::Diagonal);
    EXPECT_EQ(narrowestMode({0.6, 0, 0, 0, 0.6, 0, 0, 0, 0.6}), MatrixMode::Scalar);
    EXPECT_EQ(narrowestMode({0.6, 0, 0, 0, 0.6, 0, 0, -1e-300, 0.6}), MatrixMode::Full);
}

TEST(MatrixModes, APickedModeYieldsToAMatrixThatHasOutgrownIt)
{
    MatrixMemory memory;
    memory.picked = MatrixMode::Diagonal;
    EXPECT_EQ(modeOf(clay, memory), MatrixMode::Full);
    EXPECT_EQ(modeOf({0.6, 0, 0, 0, 0.6, 0, 0, 0, 0.6}, memory), MatrixMode::Diagonal);
}

TEST(MatrixModes, DiagonalKeepsTheDiagonalAndFullRestoresTheRest)
{
    MatrixMemory memory;
    const MatrixValues narrow = switched(clay, MatrixMode::Diagonal, memory);
    EXPECT_EQ(narrow, (MatrixValues{0.62, 0, 0, 0, 0.34, 0, 0, 0, 0.22}));
    EXPECT_EQ(switched(narrow, MatrixMode::Full, memory), clay);
}

TEST(MatrixModes, AnEditedDiagonalStaysAsEdited)
{
    MatrixMemory memory;
    MatrixValues K = switched(clay, MatrixMode::Diagonal, memory);
    K[0] = 0.5;
    K = switched(K, MatrixMode::Full, memory);
    EXPECT_EQ(K[0], 0.5);
    EXPECT_EQ(K[1], clay[1]);
}

TEST(MatrixModes, ScalarIsTheMeanAndComesBackExactly)
{
    for (const MatrixMode wide : {MatrixMode::Diagonal, MatrixMode::Full}) {
        MatrixMemory memory;
        const MatrixValues start = wide == MatrixMode::Full ? clay : MatrixValues{0.62, 0, 0, 0, 0.34, 0, 0, 0, 0.22};
        const MatrixValues grey = switched(start, MatrixMode::Scalar, memory);
        EXPECT_DOUBLE_EQ(grey[0], (0.62 + 0.34 + 0.22) / 3.0);
        EXPECT_EQ(narrowestMode(grey), MatrixMode::Scalar);
        EXPECT_EQ(switched(grey, wide, memory), start);
    }
}

TEST(MatrixModes, OffDiagonalsSurviveTwoNarrowings)
{
    MatrixMemory memory;
    MatrixValues K = switched(clay, MatrixMode::Diagonal, memory);
    K = switched(K, MatrixMode::Scalar, memory);
    K = switched(K, MatrixMode::Full, memory);
    EXPECT_EQ(K, clay);
}

TEST(MatrixModes, AScalarThatWasDraggedScalesTheColour)
{
    MatrixMemory memory;
    MatrixValues K = switched(clay, MatrixMode::Scalar, memory);
    const double mean = K[0];
    K[0] = K[4] = K[8] = 2.0 * mean;
    K = switched(K, MatrixMode::Diagonal, memory);
    EXPECT_DOUBLE_EQ(K[0], 2.0 * 0.62);
    EXPECT_DOUBLE_EQ(K[8], 2.0 * 0.22);
}

TEST(MatrixModes, EqualNumbersAreTheirOwnMean)
{
    // (0.3 + 0.3 + 0.3) / 3 misses 0.3 by a bit.
    MatrixMemory memory;
    const MatrixValues K = {0.3, 0, 0, 0, 0.3, 0, 0, 0, 0.3};
    memory.picked = MatrixMode::Full;
    EXPECT_EQ(switched(K, MatrixMode::Scalar, memory), K);
}

TEST(MatrixModes, MeasureWhatADiagonalDrops)
{
    // Nine numbers are summed: a few roundings.
    EXPECT_NEAR(offDiagonalShare(clay), 0.23 / 1.18, 1e-15);
    EXPECT_EQ(offDiagonalShare({0.6, 0, 0, 0, 0.3, 0, 0, 0, 0.2}), 0.0);
    EXPECT_EQ(offDiagonalShare({}), 0.0);
}

TEST(MatrixModes, RemarkOnRowsAboveOneAndOnNegativeEntries)
{
    EXPECT_TRUE(matrixRemarks(clay).empty());
    const auto remarks = matrixRemarks({0.9, 0.3, 0, 0, 0.3, 0, -0.1, 0, 0.2});
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_THAT(remarks[0], testing::HasSubstr("red sensor gets 1.2 times"));
    EXPECT_THAT(remarks[1], testing::HasSubstr("negative"));
}

} // namespace
} // namespace reflectance::explorer
