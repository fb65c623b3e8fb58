// The table page's light meets the cell that was clicked, and its facts belong to the table that is shown.
#include "app/explorer/table_study.h"
#include "core/math/angle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

std::shared_ptr<const MeasuredTable> tableOf(double f)
{
    Table table;
    table.axes = {{0.0, 0.5, 1.0, 1.5}, {0.0, 0.5, 1.0, 1.5}};
    table.values.assign(16, f);
    return measuredTable(std::move(table));
}

TEST(TableStudy, PutsTheLightWhereTheCellIsMet)
{
    const Camera camera;
    const CameraFrame frame = frameOf(camera);
    for (const double thetaR : {0.0, 25.0, 80.0})
        for (const double thetaI : {0.0, 40.0, 85.0})
            for (const double deltaPhi : {0.0, 90.0, 180.0}) {
                const Vec3d L = lightFor(camera, {thetaI, thetaR}, deltaPhi);
                const double tilt = radians(thetaR);
                const Vec3d N = std::cos(tilt) * frame.back + std::sin(tilt) * frame.right;
                EXPECT_NEAR(length(L), 1.0, 1e-12);
                EXPECT_NEAR(dot(N, L), std::cos(radians(thetaI)), 1e-12);
                // L.V = cos i cos r + sin i sin r cos(deltaPhi): spherical trigonometry.
                EXPECT_NEAR(dot(L, frame.back),
                            std::cos(radians(thetaI)) * std::cos(tilt) +
                                std::sin(radians(thetaI)) * std::sin(tilt) * std::cos(radians(deltaPhi)),
                            1e-12);
            }
}

TEST(TableStudy, FindsTheFactsOfTheTableThatIsShown)
{
    TablePage page;
    Worker<TableFacts> worker([] {});
    std::shared_ptr<const MeasuredTable> asked;
    renewMap(page, tableOf(0.25), false);
    ASSERT_FALSE(page.map.values.empty());
    EXPECT_NEAR(page.map.values[0], 0.25, 1e-12);
    while (!page.facts)
        pollTableFacts(page, worker, asked);
    EXPECT_EQ(page.facts->reciprocity.worst, 0.0) << "a constant is reciprocal";
    renewMap(page, tableOf(0.5), false); // planted: another table must not keep these facts
    EXPECT_FALSE(page.facts);
    EXPECT_NEAR(page.map.values[0], 0.5, 1e-12);
    renewMap(page, nullptr, false);
    EXPECT_TRUE(page.map.values.empty());
}

} // namespace
} // namespace reflectance::explorer
