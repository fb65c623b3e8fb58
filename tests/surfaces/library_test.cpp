// The library: every group says what it is, names lead to surfaces, a search finds what it should and nothing else.
#include "core/surfaces/library.h"

#include <gmock/gmock.h>
#include <set>

namespace reflectance {
namespace {

using testing::HasSubstr;

TEST(Library, EveryGroupSaysWhereItsNumbersComeFromAndHowTheyAreMeant)
{
    ASSERT_FALSE(surfaceGroups().empty());
    for (const auto& group : surfaceGroups()) {
        for (const std::string& text : {group->id, group->name, group->source, group->convention, group->note})
            EXPECT_FALSE(text.empty()) << group->id;
        EXPECT_TRUE(findModel(group->model)) << group->id;
    }
}

TEST(Library, EveryIdIsThereOnceAndLeadsToItsSurface)
{
    std::set<std::string> ids;
    for (const LibrarySurface& surface : surfaceLibrary()) {
        EXPECT_TRUE(ids.insert(surface.id).second) << surface.id;
        const auto found = findSurface(surface.id);
        ASSERT_TRUE(found) << surface.id;
        EXPECT_EQ(*found, &surface);
    }
}

TEST(Library, ANameOfItsOwnIsEnoughAndAWrongOneIsCorrected)
{
    const auto missing = findSurface("velvt");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message, HasSubstr("'velvet'"));
    EXPECT_TRUE(findSurface("curet_oren_nayar/velvet"));
    EXPECT_TRUE(findSurface("Gold"));
    const auto several = findSurface("nickel");
    ASSERT_FALSE(several) << "three fits of one material";
    EXPECT_THAT(several.error().message, HasSubstr("ngan_blinn_phong/nickel, ngan_ward/nickel, ngan_cook_torrance/nickel"));
}

TEST(Library, ASearchWantsEveryWordAndAsksNameGroupAndSource)
{
    const auto plaster = searchSurfaces("PLASTER refit", "curet_oren_nayar");
    ASSERT_EQ(plaster.size(), 3U);
    for (const LibrarySurface* surface : plaster)
        EXPECT_THAT(surface->name, HasSubstr("Plaster"));
    EXPECT_TRUE(searchSurfaces("plaster granite").empty());
    EXPECT_TRUE(searchSurfaces("plaster", "no such group").empty());
    EXPECT_EQ(searchSurfaces("").size(), surfaceLibrary().size());
    EXPECT_EQ(searchSurfaces("Dana", "curet_oren_nayar").size(), 61U) << "authors stand in the source";
}

TEST(Library, ApplyingSetsWhatTheSurfaceGivesAndKeepsWhatOtherModelsOwn)
{
    const LibrarySurface& velvet = **findSurface("curet_oren_nayar/velvet");
    const ParameterValues before{{"n", {123.0}}, {"sigma", {0.1}}};
    const ParameterValues after = withSurface(velvet, before);
    EXPECT_EQ(after.at("n"), before.at("n")) << "Phong's exponent belongs to other models";
    EXPECT_EQ(after.at("sigma"), std::vector<double>{1.4});
    EXPECT_TRUE(isSurface(velvet, after));
    EXPECT_FALSE(isSurface(velvet, before));
}

TEST(Library, PutsNumbersInBriefWithoutHidingAny)
{
    EXPECT_EQ(inBrief({0.1, 0, 0, 0, 0.2, 0, 0, 0, 0.3}), "0.1 0.2 0.3");
    EXPECT_EQ(inBrief({0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1}), "0.1");
    EXPECT_EQ(inBrief({1, 2, 3, 4, 5, 6, 7, 8, 9}), "1 2 3 4 5 6 7 8 9");
    EXPECT_EQ(inBrief(std::vector<double>(55, 0.5)), "55 numbers");
}

} // namespace
} // namespace reflectance
