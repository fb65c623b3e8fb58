#include "app/explorer/study_renderer.h"

#include "app/explorer/session.h"
#include "app/explorer/user_folders.h"

namespace reflectance::explorer {

GlRenderer* studyRenderer(Session& session)
{
    if (session.bench)
        return &*session.bench;
    Result<GlRenderer> made = GlRenderer::create(Window::loader(), programsFolder());
    if (!made) {
        session.state.message = Message{made.error().sentence(), true};
        return nullptr;
    }
    return &session.bench.emplace(*std::move(made));
}

} // namespace reflectance::explorer
