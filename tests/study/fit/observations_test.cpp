#include "core/study/fit/observations.h"
#include "tests/study/fit/synthetic.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace reflectance;

TEST(Observations, ATableGivesItsSamplesWithTheCosine)
{
    const Table table = synthetic({"lambert", {{"kd", {0.6}}}, 0.0, 1, 1, {}});
    const Observations data = observationsOf(table);
    ASSERT_EQ(data.rows.size(), table.samples());
    for (std::size_t i = 0; i < data.rows.size(); ++i)
        EXPECT_NEAR(data.seen[i].x, 0.6 * data.rows[i].lights[0].L.z, 1e-15);
}

TEST(Observations, HolesAndDirectionsBelowTheSurfaceAreLeftOut)
{
    Table table;
    table.system = AngleSystem::HalfDifference;
    table.axes = {{0.0, 1.2}, {0.0, 1.2}, {0.0}};
    table.values = {1.0, 2.0, 3.0, 4.0}; // the last pair has its viewer below the surface
    table.provenance.name = "half";
    EXPECT_EQ(observationsOf(table).rows.size(), 3U);
    table.values[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(observationsOf(table).rows.size(), 2U);
}

TEST(Observations, ALargeTableIsThinnedEvenly)
{
    const Table table = synthetic({"lambert", {}, 0.0, 1, 1, {}});
    const Observations data = observationsOf(table, 100);
    EXPECT_LE(data.rows.size(), 100U);
    EXPECT_GT(data.rows.size(), 50U);
    double largest = 0.0;
    for (const Observation& row : data.rows)
        largest = std::max(largest, std::acos(row.V.z));
    EXPECT_NEAR(largest, 70.0 * std::numbers::pi / 180.0, 1e-9); // all of the axis is still met
}

TEST(Observations, GreyIsTheMeanOfTheChannels)
{
    const ParameterValues K{{"K", {0.9, 0.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.0, 0.3}}};
    for (const std::size_t channels : {3U, 9U}) {
        const Observations grey = greyOf(observationsOf(synthetic({"lambert_color", K, 0.0, 1, channels, {}})));
        EXPECT_EQ(grey.form, ObservedForm::Grey);
        ASSERT_EQ(grey.rows.size(), 392U) << channels;
        for (std::size_t i = 0; i < grey.rows.size(); ++i)
            EXPECT_NEAR(grey.seen[i].x, 0.6 * grey.cosine[i], 1e-14) << channels;
    }
}

TEST(Observations, TheNearestSampleToTheMirrorDirectionIsMeasured)
{
    SyntheticTable wanted{"lambert", {}, 0.0, 1, 1, {}};
    EXPECT_NEAR(nearestMirror(observationsOf(synthetic(wanted))), 0.0, 1e-7);
    wanted.isSeen = [](const Vec3d& L, const Vec3d& V) { return degreesOffMirror(L, V) > 25.0; };
    const double nearest = nearestMirror(observationsOf(synthetic(wanted))) * 180.0 / std::numbers::pi;
    EXPECT_GT(nearest, 25.0);
    EXPECT_LT(nearest, 35.0);
    EXPECT_EQ(nearestMirror(Observations()), std::numbers::pi);
}
