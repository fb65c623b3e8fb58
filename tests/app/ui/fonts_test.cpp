// Every character that the interface writes has a glyph.
#include "app/explorer/ui/fonts.h"
#include "app/explorer/ui/formula.h"
#include "app/explorer/ui/shortcuts.h"
#include "core/reflectance/catalogue.h"
#include "tests/app/ui/stage.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

namespace reflectance::explorer {
namespace {

/// The first character without a glyph, 0 where there is none.
unsigned int missingIn(Face which, const std::string& text)
{
    const char* at = text.c_str();
    while (*at) {
        unsigned int c = 0;
        at += ImTextCharFromUtf8(&c, at, nullptr);
        if (c >= ' ' && !face(which)->FindGlyphNoFallback(static_cast<ImWchar>(c)))
            return c;
    }
    return 0;
}

TEST(Fonts, HaveGreekSubscriptsArrowsAndSigns)
{
    const Stage stage;
    for (const Face which : {Face::Body, Face::Strong, Face::Small, Face::Italic, Face::ItalicSmall})
        EXPECT_EQ(missingIn(which,
                            "\u03B1\u03B8\u03C6\u03C1\u03C3\u03A3 \u2080\u2081\u2099 \u2070\u00B9\u00B2\u2077\u207B "
                            "\u2191\u2192 \u2212\u00D7\u00B7\u00B0\u221E \u2713\u2717 \u2026\u2022\u2009"),
                  0U);
}

TEST(Fonts, CoverEveryModelAndShortcut)
{
    const Stage stage;
    for (const Model& model : catalogue()) {
        const ModelText& text = model.text;
        for (const std::string& words :
             {text.name, text.about, text.citation, text.reciprocal.reason, text.passive.reason})
            EXPECT_EQ(missingIn(Face::Body, words), 0U) << words;
        for (const FormulaPiece& piece : typeset(text.formula, text.parameters))
            EXPECT_EQ(missingIn(piece.style == PieceStyle::Upright ? Face::Body : Face::Italic, piece.text), 0U)
                << piece.text;
        for (const Parameter& parameter : text.parameters)
            EXPECT_EQ(missingIn(Face::Body, parameter.label + parameter.unit + parameter.tooltip + parameter.source),
                      0U)
                << parameter.name;
    }
    for (const Shortcut& shortcut : shortcuts())
        EXPECT_EQ(missingIn(Face::Body, std::string(shortcut.gesture) + shortcut.effect), 0U) << shortcut.gesture;
}

TEST(Fonts, MissWhatTheyDoNotHave)
{
    const Stage stage;
    EXPECT_EQ(missingIn(Face::Body, "a\u4E2D"), 0x4E2DU) << "the check must find a Chinese character that Inter lacks";
}

TEST(Fonts, GiveAllDigitsOneWidth)
{
    const Stage stage;
    for (ImWchar digit = '0'; digit <= '9'; ++digit)
        EXPECT_EQ(face(Face::Body)->GetCharAdvance(digit), face(Face::Body)->GetCharAdvance('0'));
}

TEST(Fonts, FollowTheScale)
{
    float sizes[2] = {};
    for (const int scale : {1, 2}) {
        const Stage stage(800.0F, 600.0F, static_cast<float>(scale));
        sizes[scale - 1] = points(10.0F);
    }
    EXPECT_EQ(sizes[0], 10.0F);
    EXPECT_EQ(sizes[1], 20.0F);
}

} // namespace
} // namespace reflectance::explorer
