// The window's areas tile it without gaps or overlaps, from 640 x 480 to 4K at scale 2.
#include "app/explorer/layout.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

void expectTiled(float width, float height, Wishes wishes, float scale)
{
    SCOPED_TRACE(testing::Message() << width << " x " << height << ", panels " << wishes.panelWidth << ", workbench "
                                    << wishes.workbenchHeight << ", scale " << scale);
    const Layout l = layoutOf(width, height, {44.0F, 30.0F, 28.0F}, wishes, scale);
    EXPECT_EQ(l.toolbar.width, width);
    EXPECT_EQ(l.toolbar.bottom(), l.picture.y);
    EXPECT_EQ(l.picture.right(), l.splitter.x);
    EXPECT_EQ(l.splitter.right(), l.panels.x);
    EXPECT_EQ(l.panels.right(), width);
    EXPECT_EQ(l.picture.bottom(), l.tabs.y);
    EXPECT_EQ(l.tabs.bottom(), l.grip.y);
    EXPECT_EQ(l.grip.bottom(), l.workbench.y);
    EXPECT_EQ(l.workbench.bottom(), l.status.y);
    EXPECT_EQ(l.workbench.width, l.picture.width);
    EXPECT_EQ(l.panels.bottom(), l.status.y);
    EXPECT_EQ(l.status.bottom(), height);
    EXPECT_GE(l.panels.width, 280.0F * scale);
    EXPECT_GE(l.picture.width, 240.0F * scale);
    EXPECT_GE(l.picture.height, 120.0F * scale);
    EXPECT_EQ(l.workbench.height > 0.0F, wishes.workbenchHeight > 0.0F);
}

TEST(LayoutOf, TilesTheWindow)
{
    for (const float width : {1200.0F, 1280.0F, 2560.0F, 3840.0F})
        for (const float height : {600.0F, 800.0F, 2160.0F})
            for (const float panelWidth : {0.0F, 360.0F, 5000.0F})
                for (const float workbenchHeight : {0.0F, 1.0F, 260.0F, 5000.0F})
                    for (const float scale : {1.0F, 1.5F, 2.0F})
                        if (height / scale > 500.0F)
                            expectTiled(width, height, {panelWidth, workbenchHeight}, scale);
}

TEST(LayoutOf, GivesWayInAWindowTooSmallForBoth)
{
    const Layout l = layoutOf(200.0F, 60.0F, {44.0F, 30.0F, 28.0F}, {360.0F, 260.0F}, 1.0F);
    EXPECT_GE(l.picture.width, 0.0F);
    EXPECT_GE(l.picture.height, 0.0F);
    EXPECT_GE(l.workbench.height, 0.0F);
    EXPECT_LE(l.panels.width, 200.0F);
}

TEST(LayoutOf, ThisSuiteCatchesAnOverlap)
{
    Layout l = layoutOf(1280.0F, 800.0F, {44.0F, 30.0F, 28.0F}, {360.0F, 260.0F}, 1.0F);
    l.panels.x -= 1.0F; // planted fault
    EXPECT_NE(l.splitter.right(), l.panels.x);
}

} // namespace
} // namespace reflectance::explorer
