// How long drawing takes.
#pragma once

#include "core/render/gl/gl_objects.h"

#include <functional>

namespace reflectance {

/// Milliseconds from when everything before is drawn until all that `work` asks for is. By the wall.
[[nodiscard]] double wallMillisecondsOf(const Gl& gl, const std::function<void()>& work);

/// The same by the driver's own clock (GL_TIME_ELAPSED): what the graphics card takes, without the way there and back, which
/// on a card is often longer than a small picture. `work` must not do the same within.
[[nodiscard]] double cardMillisecondsOf(const Gl& gl, const std::function<void()>& work);

} // namespace reflectance
