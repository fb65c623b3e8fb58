// The renderer that studies draw with, so that the picture's own buffers stay.
#pragma once

#include "core/render/gl/gl_renderer.h"

namespace reflectance::explorer {

struct Session;

/// Made when first asked for; null, and said, where GL refuses.
[[nodiscard]] GlRenderer* studyRenderer(Session& session);

} // namespace reflectance::explorer
