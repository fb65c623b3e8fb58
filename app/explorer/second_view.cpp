#include "app/explorer/second_view.h"

#include "app/explorer/user_folders.h"

namespace reflectance::explorer {

Result<void> SecondView::render(const Scene& b, const RenderSettings& settings)
{
    if (!renderer) {
        Result<GlRenderer> made = GlRenderer::create(load, programsFolder());
        if (!made)
            return made.error();
        renderer.emplace(*std::move(made));
    }
    return renderer->render(b, settings);
}

std::uint64_t SecondView::pictures() const
{
    return renderer ? renderer->work().shadings + renderer->work().developments : 0;
}

} // namespace reflectance::explorer
