// The status line gets shorter where there is little room, and never longer than the room.
#include "app/explorer/ui/status_texts.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

using enum PartForm;

float widthOf(std::span<const PartWidth> parts, std::span<const PartForm> forms)
{
    float total = 0.0F;
    for (std::size_t i = 0; i < parts.size(); ++i)
        total += forms[i] == Full ? parts[i].full : forms[i] == Brief ? parts[i].brief : 0.0F;
    return total;
}

const std::vector<PartWidth> line = {{100, 40, 8}, {80, 30, 5}, {200, 60, 1}, {120, 50, 4}};

TEST(StatusLine, IsWholeWhereThereIsRoom)
{
    EXPECT_THAT(formsThatFit(line, 500), testing::Each(Full));
}

TEST(StatusLine, ShortensTheLightestPartFirst)
{
    EXPECT_THAT(formsThatFit(line, 499), testing::ElementsAre(Full, Full, Brief, Full));
    EXPECT_THAT(formsThatFit(line, 300), testing::ElementsAre(Full, Full, Brief, Brief));
}

TEST(StatusLine, DropsPartsOnlyWhenAllAreBrief)
{
    EXPECT_THAT(formsThatFit(line, 180), testing::Each(Brief));
    EXPECT_THAT(formsThatFit(line, 179), testing::ElementsAre(Brief, Brief, Gone, Brief));
}

TEST(StatusLine, AlwaysFits)
{
    for (float room = 0.0F; room < 600.0F; room += 7.0F)
        EXPECT_LE(widthOf(line, formsThatFit(line, room)), room);
}

TEST(StatusLine, SaysTrianglesRendererAndTime)
{
    ExplorerState state;
    auto mesh = std::make_shared<Mesh>();
    mesh->triangles.resize(69451);
    state.scene.mesh = mesh;
    state.frameMilliseconds = 12.34;
    state.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    const auto parts = pictureParts(state);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].brief, "12.3 ms");
    EXPECT_EQ(parts[1].full, "69\u2009451 triangles");
    EXPECT_EQ(parts[1].brief, "69.5k tri");
    EXPECT_EQ(parts[2].brief, "llvmpipe");
}

TEST(StatusLine, SaysWhatEachPrecisionCostsAndMisses)
{
    ExplorerState state;
    state.scene.environment.kind = EnvironmentKind::None; // nothing left out
    state.scene.surface.values["ks"] = {0.2, 0.3, 0.4};   // nor here, where ks is a colour and K full
    state.priceTags = {{"double", 41.2, 0.0, 0.0, -1, -1}, {"float", 22.1, 1.9e-6, 1e-8, 5, 7}};
    const auto parts = priceParts(state);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].full, "double 41.2 ms, exact");
    EXPECT_EQ(parts[1].full, "float 22.1 ms, error 1.9\u00D710\u207B\u2076");
    EXPECT_THAT(parts[1].about, testing::HasSubstr("(5, 7)"));
}

TEST(StatusLine, SaysWhatWasLeftOut)
{
    ExplorerState state;
    state.scene.surface.model = "lambert";
    state.scene.environment.kind = EnvironmentKind::Studio;
    const auto parts = priceParts(state);
    ASSERT_FALSE(parts.empty());
    EXPECT_EQ(parts[0].brief, "2 left out");
    EXPECT_THAT(parts[0].about, testing::HasSubstr("environment"));
    EXPECT_THAT(parts[0].about, testing::HasSubstr("where the samples lie"));
    EXPECT_THAT(parts[0].about, testing::Not(testing::HasSubstr("Shading with everything")));
}

TEST(StatusLine, SaysWhatLeavingOutSaves)
{
    ExplorerState state;
    state.scene.surface.values["ks"] = {0.0};
    state.priceTags = {{"double", 8.0, 0.0, 0.0, -1, -1}, {"simd", 1.5, 1e-6, 1e-8, 5, 7, 2.0}};
    EXPECT_THAT(priceParts(state)[0].full, testing::EndsWith(", saves 25 %"));
    EXPECT_THAT(priceParts(state)[0].about, testing::HasSubstr("in simd: 2 ms; without: 1.5 ms, 25 % less."));
    state.priceTags[1].generalMilliseconds = 1.4; // noise
    EXPECT_THAT(priceParts(state)[0].full, testing::Not(testing::HasSubstr("saves")));
    EXPECT_THAT(priceParts(state)[0].about, testing::HasSubstr("no less."));
}

} // namespace
} // namespace reflectance::explorer
