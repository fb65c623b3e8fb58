// Every GL test runs in OSMesa's context and in EGL's: the same expectations, one renderer.
#pragma once

#include "core/render/gl/gl_renderer.h"

#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>

namespace reflectance::test {

class GlTest : public testing::TestWithParam<ContextKind> {
protected:
    void SetUp() override { startAnew(); }

    /// A context and a renderer that has drawn nothing yet.
    void startAnew(const std::filesystem::path& programs = {})
    {
        renderer_.reset();
        context_.reset();
        auto context = openHeadless(GetParam());
        ASSERT_TRUE(context) << context.error().sentence();
        context_ = *std::move(context);
        auto renderer = GlRenderer::create(context_->loader(), programs);
        ASSERT_TRUE(renderer) << renderer.error().sentence();
        renderer_.emplace(*std::move(renderer));
    }

    /// Driver complaints are errors of render(), so this asserts their absence too.
    void render(const Scene& scene, const RenderSettings& settings)
    {
        const auto done = renderer_->render(scene, settings);
        ASSERT_TRUE(done) << done.error().sentence();
    }

    [[nodiscard]] GlRenderer& renderer() { return *renderer_; }
    [[nodiscard]] HeadlessContext& context() { return *context_; }

private:
    std::unique_ptr<HeadlessContext> context_; // outlives the renderer
    std::optional<GlRenderer> renderer_;
};

inline std::string contextName(const testing::TestParamInfo<ContextKind>& given)
{
    return given.param == ContextKind::Egl ? "egl" : "osmesa";
}

#define IN_EVERY_CONTEXT(Suite)                                                                                        \
    INSTANTIATE_TEST_SUITE_P(, Suite, testing::Values(ContextKind::OsMesa, ContextKind::Egl), contextName)

} // namespace reflectance::test
