#include "core/render/gl/full_screen.h"

namespace reflectance {

void FullScreen::draw() const
{
    const Gl& gl = noVertices_.gl();
    gl.BindVertexArray(noVertices_.id());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void FullScreen::drawWhereSeen() const
{
    const Gl& gl = noVertices_.gl();
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_GREATER);
    gl.DepthMask(GL_FALSE);
    gl.DepthRange(1.0, 1.0);
    draw();
    gl.DepthRange(0.0, 1.0);
    gl.Disable(GL_DEPTH_TEST);
}

} // namespace reflectance
