// Text is legible on every ground it stands on, and the greys are neutral.
#include "app/explorer/ui/theme.h"

#include "core/math/srgb.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

double channel(ImU32 color, int shift)
{
    return static_cast<double>((color >> shift) & 0xFFU) / 255.0;
}

/// Relative luminance (WCAG 2.1): linear sRGB weighted by the eye's sensitivity.
double luminance(ImU32 color)
{
    return 0.2126 * decodeSrgb(channel(color, IM_COL32_R_SHIFT)) +
           0.7152 * decodeSrgb(channel(color, IM_COL32_G_SHIFT)) +
           0.0722 * decodeSrgb(channel(color, IM_COL32_B_SHIFT));
}

double contrast(ImU32 a, ImU32 b)
{
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

constexpr double legible = 4.5; // WCAG 2.1, 1.4.3, level AA

TEST(Theme, TextIsLegibleOnEveryGround)
{
    using namespace palette;
    for (const ImU32 ink : {text, quiet, accent, warning, error, good})
        for (const ImU32 paper : {ground, card, well, floating})
            EXPECT_GE(contrast(ink, paper), legible) << std::hex << ink << " on " << paper;
    for (const ImU32 paper : {raised, hovered, chosen})
        EXPECT_GE(contrast(text, paper), legible) << std::hex << paper;
    EXPECT_GE(contrast(quiet, fill), legible) << "the lower end of a range on the filled part of a slider";
}

TEST(Theme, GreysAreNeutral)
{
    using namespace palette;
    for (const ImU32 grey : {ground, card, well, raised, floating, hovered, line, text, quiet}) {
        EXPECT_EQ(channel(grey, IM_COL32_R_SHIFT), channel(grey, IM_COL32_G_SHIFT));
        EXPECT_EQ(channel(grey, IM_COL32_G_SHIFT), channel(grey, IM_COL32_B_SHIFT));
    }
}

TEST(Theme, ContrastIsMeasuredAsDefined)
{
    EXPECT_NEAR(contrast(IM_COL32_WHITE, IM_COL32_BLACK), 21.0, 1e-9);
    EXPECT_LT(contrast(IM_COL32(120, 120, 120, 255), palette::card), legible)
        << "a planted grey that is too dark to read";
}

} // namespace
} // namespace reflectance::explorer
