#include "app/explorer/ui/fonts.h"

#include "app/explorer/ui/ui.h"
#include "core/base/check.h"
#include "core/base/embedded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui_freetype.h>

namespace reflectance {

std::span<const EmbeddedFile> embeddedFonts(); // made by cmake/Embed.cmake

namespace explorer {

namespace {

struct FaceDescription {
    std::string_view file;
    float size; ///< points
};

constexpr std::array<FaceDescription, 5> faces = {{
    {"regular", 14.0F},
    {"strong", 14.0F},
    {"regular", 12.0F},
    {"italic", 15.0F},
    {"italic", 11.0F},
}};

// Latin with accents, Greek and Cyrillic (file names), punctuation, super- and subscripts, arrows, signs, shapes.
constexpr ImWchar glyphRanges[] = {0x0020, 0x017F, 0x0370, 0x04FF, 0x2000, 0x209F, 0x2190, 0x21FF,
                                   0x2200, 0x22FF, 0x25A0, 0x25FF, 0x2600, 0x27BF, 0};

std::string_view bytesOf(std::string_view name)
{
    const auto files = embeddedFonts();
    const auto found = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) { return f.name == name; });
    CHECK_LT(found - files.begin(), static_cast<std::ptrdiff_t>(files.size()));
    return found->bytes;
}

/// Gives all digits the width of the widest, so that values do not shake while they change.
void makeFiguresTabular(ImFont& font)
{
    float widest = 0.0F;
    for (ImWchar c = '0'; c <= '9'; ++c)
        widest = std::max(widest, font.GetCharAdvance(c));
    for (ImFontGlyph& glyph : font.Glyphs) {
        if (glyph.Codepoint < '0' || glyph.Codepoint > '9')
            continue;
        const float shift = std::round((widest - glyph.AdvanceX) / 2.0F);
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
    }
    font.BuildLookupTable();
}

} // namespace

ImFont* face(Face which)
{
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    CHECK_LT(static_cast<int>(which), fonts.Size);
    return fonts[static_cast<int>(which)];
}

float points(float length)
{
    return std::round(length * face(Face::Body)->FontSize / faces[0].size);
}

void loadFonts(float scale)
{
    loadFonts(*ImGui::GetIO().Fonts, scale);
}

void loadFonts(ImFontAtlas& atlas, float scale)
{
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    atlas.TexGlyphPadding = 2;
    for (const FaceDescription& description : faces) {
        const std::string_view bytes = bytesOf(description.file);
        ImFontConfig config;
        config.FontDataOwnedByAtlas = false;
        // The atlas only reads the bytes; its interface predates const.
        atlas.AddFontFromMemoryTTF(const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
                                   std::round(description.size * scale), &config, glyphRanges);
    }
    atlas.Build();
    unsigned char* pixels = nullptr; // as the back end takes them
    int width = 0, height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    makeFiguresTabular(*atlas.Fonts[static_cast<int>(Face::Body)]);
}

} // namespace explorer
} // namespace reflectance
