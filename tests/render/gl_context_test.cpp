// Contexts of different makers in one process, in any order, and what is said when there is none.
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

namespace reflectance::test {
namespace {

constexpr RenderSettings small{64, 48, 2};

struct Drawing {
    std::unique_ptr<HeadlessContext> context;
    std::unique_ptr<GlRenderer> renderer;

    explicit Drawing(ContextKind kind)
    {
        auto opened = openHeadless(kind);
        if (!opened)
            throw std::runtime_error(opened.error().sentence());
        context = *std::move(opened);
        auto made = GlRenderer::create(context->loader());
        if (!made)
            throw std::runtime_error(made.error().sentence());
        renderer = std::make_unique<GlRenderer>(*std::move(made));
    }
    Drawing(Drawing&&) = default;
    ~Drawing()
    {
        if (context)
            context->makeCurrent(); // the renderer returns its names here
    }

    std::vector<float> picture(const Scene& scene)
    {
        context->makeCurrent();
        const auto done = renderer->render(scene, small);
        EXPECT_TRUE(done) << done.error().sentence();
        return renderer->readLinear().rgb;
    }
};

class ContextPair : public testing::TestWithParam<std::pair<ContextKind, ContextKind>> {};

TEST_P(ContextPair, DrawInTurnsWithoutDisturbingEachOther)
{
    Drawing first(GetParam().first);
    Scene scene = twoLightScene("hybrid");
    const std::vector<float> alone = first.picture(scene);
    Drawing second(GetParam().second);
    EXPECT_EQ(second.picture(scene), alone) << "the same rasteriser in either context";
    for (int turn = 0; turn < 3; ++turn) {
        scene.lights[0].intensity.x *= 0.5;
        const std::vector<float> here = first.picture(scene);
        EXPECT_EQ(second.picture(scene), here);
        EXPECT_NE(here, alone) << "a picture that never changes would pass";
    }
}

TEST_P(ContextPair, OneOutlivesTheOther)
{
    const Scene scene = twoLightScene("hybrid");
    auto first = std::make_unique<Drawing>(GetParam().first);
    const std::vector<float> alone = first->picture(scene);
    Drawing second(GetParam().second);
    first.reset();
    EXPECT_EQ(second.picture(scene), alone);
}

INSTANTIATE_TEST_SUITE_P(, ContextPair,
                         testing::Values(std::pair{ContextKind::OsMesa, ContextKind::Egl},
                                         std::pair{ContextKind::Egl, ContextKind::OsMesa},
                                         std::pair{ContextKind::Egl, ContextKind::Egl},
                                         std::pair{ContextKind::OsMesa, ContextKind::OsMesa}),
                         [](const auto& given) {
                             const auto name = [](ContextKind k) { return k == ContextKind::Egl ? "egl" : "osmesa"; };
                             return std::string(name(given.param.first)) + "_" + name(given.param.second);
                         });

TEST(Context, SaysItsName)
{
    EXPECT_EQ((*openHeadless(ContextKind::OsMesa))->name(), "osmesa");
    EXPECT_EQ((*openHeadless(ContextKind::Egl))->name(), "egl");
    EXPECT_EQ((*openHeadless(ContextKind::Any))->name(), "osmesa") << "OSMesa is tried first: it starts faster";
}

TEST(Context, ARendererWithoutContextSaysSo)
{
    const auto made = GlRenderer::create([](const char*) -> GlFunction { return nullptr; });
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().message, "no OpenGL context is current");
}

class Description : public GlTest {};

TEST_P(Description, NamesTheRasteriserAndTheVersion)
{
    EXPECT_NE(renderer().description().find(", OpenGL "), std::string::npos) << renderer().description();
}

IN_EVERY_CONTEXT(Description);

} // namespace
} // namespace reflectance::test
