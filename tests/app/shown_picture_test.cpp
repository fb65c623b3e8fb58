// What is saved of one surface or two: every view of them, and the recipe that makes it again.
#include "app/explorer/shown_picture.h"

#include "core/image/picture_file.h"
#include "tests/app/scratch_folder.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

/// A picture whose pixels tell the surface's kd and their own column.
Result<Image> painted(const Scene& scene, int width, int height)
{
    Image image(width, height);
    const auto kd = static_cast<float>(scene.surface.values.at("kd")[0]);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::fill_n(image.at(x, y), 3, kd + static_cast<float>(x) / 1024.0F);
            image.coverage[static_cast<std::size_t>(y * width + x)] = 1.0F;
        }
    return image;
}

Scene twoSurfaces()
{
    Scene scene = defaultScene();
    scene.surface = Surface{"lambert", {{"kd", {0.25}}}};
    scene.other = Surface{"lambert", {{"kd", {0.5}}}};
    return scene;
}

PictureRecipe recipeOf(VariantView shown)
{
    PictureRecipe recipe{20, 4, 1};
    recipe.shown = shown;
    recipe.divider = 0.25;
    return recipe;
}

TEST(ShownPicture, ShowsTheSurfacesAsAsked)
{
    const Scene scene = twoSurfaces();
    const auto linearAt = [&](VariantView shown, int x) {
        return shownPicture(scene, recipeOf(shown), painted)->linear.at(x, 0)[0];
    };
    EXPECT_EQ(linearAt(VariantView::A, 3), 0.25F + 3.0F / 1024.0F);
    EXPECT_EQ(linearAt(VariantView::B, 3), 0.5F + 3.0F / 1024.0F);
    EXPECT_EQ(linearAt(VariantView::Wipe, 4), 0.25F + 4.0F / 1024.0F);
    EXPECT_EQ(linearAt(VariantView::Wipe, 5), 0.5F + 5.0F / 1024.0F);
    EXPECT_EQ(linearAt(VariantView::SideBySide, 8), 0.25F + 8.0F / 1024.0F);
    EXPECT_EQ(linearAt(VariantView::SideBySide, 9), 0.0F) << "the gap";
    EXPECT_EQ(linearAt(VariantView::SideBySide, 11), 0.5F) << "B's first column";
    const auto map = shownPicture(scene, recipeOf(VariantView::Difference), painted);
    ASSERT_TRUE(map);
    EXPECT_GT(map->codes.rgb[0], map->codes.rgb[2]) << "red: B is brighter";
}

TEST(ShownPicture, HasTheAskedSizeAndPanesOfOneSize)
{
    for (int width = 4; width < 40; ++width) {
        PictureRecipe recipe = recipeOf(VariantView::SideBySide);
        recipe.width = width;
        const auto picture = shownPicture(twoSurfaces(), recipe, painted);
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->codes.width, width);
        EXPECT_EQ(paneWidth(wholeWidth(width)), width);
    }
}

TEST(ShownPicture, OfOneSurfaceShowsNoOther)
{
    Scene scene = twoSurfaces();
    scene.other.reset();
    EXPECT_TRUE(shownPicture(scene, recipeOf(VariantView::A), painted));
    for (const VariantView shown :
         {VariantView::B, VariantView::SideBySide, VariantView::Wipe, VariantView::Difference})
        EXPECT_FALSE(shownPicture(scene, recipeOf(shown), painted));
}

TEST(ShownPicture, IsMadeAgainEqualFromWhatItCarries)
{
    const ScratchFolder scratch;
    for (const VariantView shown :
         {VariantView::A, VariantView::B, VariantView::SideBySide, VariantView::Wipe, VariantView::Difference}) {
        const std::string file = (scratch.path / (std::string(nameOf(shown)) + ".png")).string();
        const auto picture = shownPicture(twoSurfaces(), recipeOf(shown), painted);
        ASSERT_TRUE(picture);
        ASSERT_TRUE(saveShown(file, *picture, twoSurfaces(), recipeOf(shown)));
        const auto kept = loadKept(file);
        ASSERT_TRUE(kept) << kept.error().sentence();
        EXPECT_EQ(kept->recipe, recipeOf(shown));
        const auto again = shownPicture(kept->scene, kept->recipe, painted);
        ASSERT_TRUE(again);
        EXPECT_EQ(again->codes.rgb, picture->codes.rgb) << nameOf(shown);
        Scene other = kept->scene; // planted: another surface must show
        other.surface.values["kd"] = {0.3};
        other.other->values["kd"] = {0.7};
        EXPECT_NE(shownPicture(other, kept->recipe, painted)->codes.rgb, picture->codes.rgb) << nameOf(shown);
    }
}

TEST(ShownPicture, OfADifferenceIsNoLinearPicture)
{
    const ScratchFolder scratch;
    const auto map = shownPicture(twoSurfaces(), recipeOf(VariantView::Difference), painted);
    ASSERT_TRUE(map);
    const auto saved =
        saveShown((scratch.path / "a.exr").string(), *map, twoSurfaces(), recipeOf(VariantView::Difference));
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().sentence().find(".png"), std::string::npos);
}

} // namespace
} // namespace reflectance::explorer
