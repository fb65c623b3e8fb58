// What can go wrong becomes one sentence, and the renderer draws on afterwards.
#include "core/base/text.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

namespace reflectance::test {
namespace {

class GlErrors : public GlTest {
protected:
    [[nodiscard]] Error errorOf(const Scene& scene, const RenderSettings& settings)
    {
        const auto done = renderer().render(scene, settings);
        return done ? Error{"it was drawn"} : done.error();
    }
};

TEST_P(GlErrors, ABrokenModelTextIsNamedByFileAndLine)
{
    Model broken = **findModel("phong");
    broken.text.id = "broken";
    broken.text.file = "shaders/reflectance/broken.glsl";
    const std::size_t place = broken.text.code.find("return gate(");
    const auto line = static_cast<long>(split(broken.text.code.substr(0, place), '\n').size());
    broken.text.code.replace(place, 12, "return gait(");
    const Observation row{{0, 0, 1}, {0, 0, 1}, {{{0, 0, 1}, {1, 1, 1}}}};
    const auto got = renderer().evaluate(broken, flatValues(broken.text, {}), {&row, 1});
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().file, "shaders/reflectance/broken.glsl") << got.error().sentence();
    EXPECT_EQ(got.error().line, line);
    EXPECT_NE(got.error().message.find("gait"), std::string::npos) << got.error().message;
    render(twoLightScene("phong"), {16, 16, 1}); // the renderer is none the worse
}

TEST_P(GlErrors, APictureTooLargeForATextureIsRefusedBeforeAnythingIsAllocated)
{
    const Scene scene = twoLightScene("phong");
    render(scene, {16, 16, 1});
    const std::uint64_t before = renderer().work().allocations;
    const Error wide = errorOf(scene, {16384, 16, 8});
    EXPECT_NE(wide.message.find("16384x16 with 64 samples per pixel needs a texture of 131072"), std::string::npos)
        << wide.message;
    const Error heavy = errorOf(scene, {8192, 8192, 2});
    EXPECT_NE(heavy.message.find("GiB"), std::string::npos) << heavy.message;
    EXPECT_NE(heavy.message.find("--backend cpu"), std::string::npos) << heavy.message;
    EXPECT_EQ(renderer().work().allocations, before);
    EXPECT_EQ(renderer().readLinear().width, 16) << "the last picture is kept";
}

IN_EVERY_CONTEXT(GlErrors);

} // namespace
} // namespace reflectance::test
