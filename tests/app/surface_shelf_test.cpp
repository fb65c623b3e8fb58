// The shelf of surfaces: applying and going back, and thumbnails that show the surface they are called after.
#include "app/explorer/surface_shelf.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

const LibrarySurface& surface(const char* id)
{
    return **findSurface(id);
}

TEST(Shelf, GoesBackToWhatWasThereBeforeTheFirstClick)
{
    SurfaceShelf shelf;
    Surface inHand{"phong", {{"n", {77.0}}}};
    const Surface first = inHand;
    EXPECT_FALSE(canGoBack(shelf, inHand));
    applyFromShelf(shelf, surface("curet_oren_nayar/velvet"), inHand);
    applyFromShelf(shelf, surface("curet_oren_nayar/felt"), inHand);
    EXPECT_EQ(inHand.model, "oren_nayar");
    EXPECT_EQ(inHand.values.at("n")[0], 77.0) << "what other models own stays";
    ASSERT_TRUE(canGoBack(shelf, inHand));
    goBack(shelf, inHand);
    EXPECT_EQ(inHand, first);
    EXPECT_FALSE(canGoBack(shelf, inHand));
}

TEST(Shelf, WhatWasChangedByHandIsNotThrownAway)
{
    SurfaceShelf shelf;
    Surface inHand{"phong", {}};
    applyFromShelf(shelf, surface("curet_oren_nayar/velvet"), inHand);
    inHand.values["sigma"] = {0.5};
    EXPECT_FALSE(canGoBack(shelf, inHand));
    const Surface edited = inHand;
    applyFromShelf(shelf, surface("curet_oren_nayar/felt"), inHand);
    goBack(shelf, inHand);
    EXPECT_EQ(inHand, edited);
}

double meanOf(const Thumbnail& thumbnail)
{
    double sum = 0.0;
    for (const std::uint8_t code : thumbnail.rgb)
        sum += code;
    return sum / static_cast<double>(thumbnail.rgb.size());
}

TEST(Thumbnails, ShowEachSurfaceUnderTheScenesLights)
{
    Progress progress;
    Scene scene = defaultScene();
    const std::vector<std::string> ids{"curet_oren_nayar/moss", "curet_oren_nayar/plaster_a"};
    const auto made = makeThumbnails(scene, ids, progress);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->size(), 2U);
    EXPECT_EQ((*made)[0].id, ids[0]);
    EXPECT_EQ((*made)[0].rgb.size(), 3U * thumbnailSize * thumbnailSize);
    EXPECT_GT(meanOf((*made)[1]), 2.0 * meanOf((*made)[0])) << "plaster is ten times as bright as moss";
    EXPECT_GT((*made)[1].budget.largest, (*made)[0].budget.largest);
    scene.lights.clear();
    EXPECT_LT(meanOf(makeThumbnails(scene, ids, progress)->at(1)), meanOf((*made)[0])) << "no light, no sphere";
}

TEST(Thumbnails, AreGivenUpWhereNobodyWantsThem)
{
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(makeThumbnails(defaultScene(), {"curet_oren_nayar/moss"}, progress));
}

} // namespace
} // namespace reflectance::explorer
