// What GL sees against what rays see: the same samples, up to the rasteriser's grid.
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <cmath>

namespace reflectance::test {
namespace {

/// How the samples of two renderers differ, pixel by pixel.
struct Difference {
    std::size_t rim = 0;     ///< pixels that are partly covered
    std::size_t counts = 0;  ///< pixels with another number of samples
    std::size_t same = 0;    ///< samples that met the same triangle in both
    std::size_t other = 0;   ///< samples that met different triangles
    double position = 0.0;   ///< largest distance across the view, where the triangle is the same
    double normal = 0.0;     ///< largest turn of N, times N.V
};

void compareSample(const ViewSamples& a, std::size_t i, const ViewSamples& b, std::size_t j, Difference& d)
{
    if (a.triangle[i] != b.triangle[j]) {
        ++d.other;
        return;
    }
    ++d.same;
    const Vec3d P{b.Px[j], b.Py[j], b.Pz[j]};
    const Vec3d N{b.Nx[j], b.Ny[j], b.Nz[j]};
    const Vec3d V = normalized(b.eye - P);
    const Vec3d moved = Vec3d{a.Px[i], a.Py[i], a.Pz[i]} - P;
    const Vec3d turned = Vec3d{a.Nx[i], a.Ny[i], a.Nz[i]} - N;
    d.position = std::fmax(d.position, length(moved - dot(moved, V) * V));
    d.normal = std::fmax(d.normal, length(turned) * std::fabs(dot(N, V)));
}

Difference compare(const ViewSamples& a, const ViewSamples& b)
{
    Difference d;
    const auto full = static_cast<std::uint32_t>(a.settings.samplesPerAxis * a.settings.samplesPerAxis);
    for (std::size_t pixel = 0; pixel + 1 < a.firstOfPixel.size(); ++pixel) {
        const std::uint32_t count = a.firstOfPixel[pixel + 1] - a.firstOfPixel[pixel];
        d.rim += count > 0 && count < full ? 1U : 0U;
        if (count != b.firstOfPixel[pixel + 1] - b.firstOfPixel[pixel])
            ++d.counts;
        else
            for (std::uint32_t s = 0; s < count; ++s)
                compareSample(a, a.firstOfPixel[pixel] + s, b, b.firstOfPixel[pixel] + s, d);
    }
    return d;
}

class GlCoverage : public GlTest {};

TEST_P(GlCoverage, SamplesLieWhereRaysMeetTheMesh)
{
    const Scene scene = twoLightScene("lambert");
    const RenderSettings settings{320, 240, 3};
    render(scene, settings);
    const ViewSamples gl = renderer().readSamples();
    const ViewSamples rays = sampleView(*makeRayScene(scene.mesh), scene.camera, settings);
    const Difference d = compare(gl, rays);
    ASSERT_GT(d.same, 100000U);
    ASSERT_GT(d.rim, 300U);
    // Corners are snapped to 1/256 of a sample, so an edge passes a sample on the other side once in about 100.
    EXPECT_LE(d.counts, d.rim / 10);
    EXPECT_LE(d.other, d.same / 200);
    // Eye and ray, 3.3 away, are rounded to float, 2e-7 each; a triangle seen nearly edge-on multiplies that by ten and
    // more. Still P stays within 1/500 of a sample's width, 2.9e-3, of its ray. On a unit sphere N turns by as much as P
    // moves along the surface, which is 1 / (N.V) times what it moves across the view.
    EXPECT_LE(d.position, 6e-6);
    EXPECT_LE(d.normal, 6e-6);
}

TEST_P(GlCoverage, OrderIsThePixelsOrder)
{
    const Scene scene = twoLightScene("lambert");
    const RenderSettings settings{40, 30, 4};
    render(scene, settings);
    const ViewSamples gl = renderer().readSamples();
    ASSERT_EQ(gl.firstOfPixel.size(), 40U * 30U + 1U);
    ASSERT_EQ(gl.firstOfPixel.back(), gl.count());
    for (std::size_t pixel = 0; pixel < 40U * 30U; ++pixel)
        for (std::uint32_t s = gl.firstOfPixel[pixel]; s < gl.firstOfPixel[pixel + 1]; ++s) {
            const Vec3d seen = projected(scene.camera, {gl.Px[s], gl.Py[s], gl.Pz[s]}, 40, 30);
            EXPECT_EQ(static_cast<std::size_t>(seen.x), pixel % 40);
            EXPECT_EQ(static_cast<std::size_t>(seen.y), pixel / 40) << "rows from the top";
        }
}

/// Triangles far smaller than a sample: the corners' snapping turns those on the rim into slivers or inside out, and
/// still P lies on the triangle that is named, and N points outwards.
TEST_P(GlCoverage, PointsLieOnTheirTriangles)
{
    const Scene scene = twoLightScene("lambert", 200); // 159 200 triangles
    render(scene, {64, 64, 1});
    const ViewSamples gl = renderer().readSamples();
    std::size_t high = 0;
    for (std::size_t i = 0; i < gl.count(); ++i) {
        ASSERT_LT(gl.triangle[i], scene.mesh->triangles.size());
        high += gl.triangle[i] > 65535 ? 1U : 0U;
        const auto& corners = scene.mesh->triangles[gl.triangle[i]];
        // An edge of this sphere is at most 2 pi / 400 long.
        const Vec3d P{gl.Px[i], gl.Py[i], gl.Pz[i]};
        EXPECT_LE(length(scene.mesh->positions[corners[0]] - P), 0.03);
        EXPECT_GE(reflectance::dot(P, {gl.Nx[i], gl.Ny[i], gl.Nz[i]}), 0.999);
    }
    EXPECT_GT(high, 100U);
    EXPECT_LT(high, gl.count());
}

TEST_P(GlCoverage, NoticesAPictureShiftedByAPixel)
{
    const Scene scene = twoLightScene("lambert");
    const RenderSettings settings{320, 240, 1};
    render(scene, settings);
    ViewSamples shifted = renderer().readSamples();
    shifted.firstOfPixel.erase(shifted.firstOfPixel.begin());
    shifted.firstOfPixel.push_back(shifted.firstOfPixel.back());
    const Difference d = compare(shifted, sampleView(*makeRayScene(scene.mesh), scene.camera, settings));
    EXPECT_GT(d.position, 1e-3) << "the planted fault";
}

IN_EVERY_CONTEXT(GlCoverage);

} // namespace
} // namespace reflectance::test
