// Reads pictures and samples back. The buffers are kept: fresh memory costs several times the copy itself.
#pragma once

#include "core/image/image.h"
#include "core/render/gl/render_target.h"
#include "core/render/settings.h"
#include "core/render/view_samples.h"

#include <vector>

namespace reflectance {

class SampleReader {
public:
    explicit SampleReader(const Gl& gl) : gl_(&gl) {}

    /// RGB and coverage, rows turned so that the top comes first.
    [[nodiscard]] Image readImage(const RenderTarget& linear);

    /// The samples that met the object, ordered by pixel; within a pixel by rows from the top, as the CPU renderer does.
    /// `surface` holds N and P.
    [[nodiscard]] ViewSamples readSamples(const RenderTarget& triangles, const RenderTarget& surface,
                                          const RenderSettings& settings, const Vec3d& eye);

private:
    /// `rows` rows of RGBA from `firstRow` (0 is the bottom) of a texture.
    void readRows(const RenderTarget& target, int texture, int firstRow, int rows, std::vector<float>& into);
    void readTriangles(const RenderTarget& target, int firstRow, int rows);

    const Gl* gl_;
    std::vector<float> first_;
    std::vector<float> second_;
    std::vector<std::uint32_t> triangles_;
};

} // namespace reflectance
