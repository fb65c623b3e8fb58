#include "core/render/gl/draw_clock.h"

#include <chrono>

namespace reflectance {

double wallMillisecondsOf(const Gl& gl, const std::function<void()>& work)
{
    gl.Finish();
    const auto start = std::chrono::steady_clock::now();
    work();
    gl.Finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double cardMillisecondsOf(const Gl& gl, const std::function<void()>& work)
{
    const GlQuery query(gl);
    gl.Finish();
    gl.BeginQuery(GL_TIME_ELAPSED, query.id());
    work();
    gl.EndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds); // waits for it
    return static_cast<double>(nanoseconds) / 1e6;
}

} // namespace reflectance
