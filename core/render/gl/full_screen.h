// One triangle that covers the picture, for the program in use (shaders/gl/fullscreen.vert).
#pragma once

#include "core/render/gl/gl_objects.h"

namespace reflectance {

class FullScreen {
public:
    explicit FullScreen(const Gl& gl) : noVertices_(gl) {}

    void draw() const;

    /// The program runs only where the target's depth lies before that of a cleared one: where something was seen.
    void drawWhereSeen() const;

private:
    GlVertexArray noVertices_;
};

} // namespace reflectance
