// What the CPU renderer shows: pictures with a closed form, and the agreement of its precisions.
#include "core/render/cpu/cpu_renderer.h"
#include "tests/render/sphere.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace reflectance::test {
namespace {

constexpr RenderSettings small{96, 96, 1};
constexpr Precision precisions[] = {Precision::Double, Precision::Float, Precision::Simd};

/// The sphere's own normal where the ray through the middle of a pixel meets it; (0,0,0) beside it.
Vec3d sphereNormal(const Camera& camera, int x, int y, const RenderSettings& settings)
{
    const Vec3d ray = rayThrough(camera, x + 0.5, y + 0.5, settings.width, settings.height);
    const double b = dot(camera.eye, ray);
    const double root = b * b - dot(camera.eye, camera.eye) + 1.0;
    return root > 0.0 ? camera.eye + (-b - std::sqrt(root)) * ray : Vec3d();
}

/// Largest difference of a picture to a closed form over the pixels well inside the sphere's outline.
template <class Closed> double worstAgainst(const Image& image, const Scene& scene, const Closed& closed)
{
    double worst = 0.0;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const Vec3d N = sphereNormal(scene.camera, x, y, small);
            const Vec3d V = normalized(scene.camera.eye - N);
            if (N == Vec3d() || dot(N, V) < 0.1)
                continue;
            const Vec3d expected = closed(N, V);
            const float* rgb = image.at(x, y);
            worst = std::max({worst, std::fabs(rgb[0] - expected.x), std::fabs(rgb[1] - expected.y),
                              std::fabs(rgb[2] - expected.z)});
        }
    return worst;
}

// A sphere of 512 rings, h = pi/512 sqrt(2): the surface lies h^2/8 = 9e-6 inside, and seen at N.V = 0.1 that moves
// the normal of the ray's hit by up to 10 times as much.
constexpr int fine = 512;
constexpr double tessellation = 1e-4;

TEST(CpuShading, LambertIsTheCosine)
{
    Scene scene = sphereScene("lambert", fine);
    scene.surface.values["kd"] = {0.5};
    scene.lights[0].intensity = {1.0, 2.0, 0.5};
    const Vec3d L = normalized(scene.lights[0].direction);
    const auto closed = [&](const Vec3d& N, const Vec3d&) {
        return 0.5 * std::max(0.0, dot(N, L)) * scene.lights[0].intensity;
    };
    for (const Precision precision : precisions)
        // The light of 2 doubles the tessellation's error, kd halves it again.
        EXPECT_LE(worstAgainst(renderOnCpu(scene, small, precision), scene, closed), tessellation) << nameOf(precision);
}

TEST(CpuShading, PhongPutsItsHighlightWhereTheMirrorDirectionIs)
{
    Scene scene = sphereScene("phong", fine);
    scene.surface.values = {{"ks", {1.0}}, {"n", {20.0}}};
    const Vec3d L = normalized(scene.lights[0].direction);
    const auto closed = [&](const Vec3d& N, const Vec3d& V) {
        const double cosine = dot(2.0 * dot(N, L) * N - L, V);
        return dot(N, L) > 0.0 && cosine > 0.0 ? Vec3d(std::pow(cosine, 20.0)) : Vec3d();
    };
    for (const Precision precision : precisions)
        // R turns twice as far as N, and the lobe's steepest slope is sqrt(n / e) = 2.7.
        EXPECT_LE(worstAgainst(renderOnCpu(scene, small, precision), scene, closed), 6.0 * tessellation)
            << nameOf(precision);
    // The planted fault: the same check must see a light that stands one degree elsewhere.
    scene.lights[0].direction = scene.lights[0].direction + Vec3d(0.03, 0.0, 0.0);
    EXPECT_GT(worstAgainst(renderOnCpu(scene, small, Precision::Double), scene, closed), 20.0 * tessellation);
}

TEST(CpuShading, PointLightsFallWithTheSquareOfTheDistance)
{
    Scene scene = sphereScene("lambert", fine);
    scene.surface.values["kd"] = {1.0};
    scene.lights[0].kind = LightKind::Point;
    scene.lights[0].position = {1.0, 0.5, 2.5};
    const auto closed = [&](const Vec3d& N, const Vec3d&) {
        const Vec3d d = scene.lights[0].position - N;
        return Vec3d(std::max(0.0, dot(N, normalized(d))) / dot(d, d));
    };
    for (const Precision precision : precisions)
        EXPECT_LE(worstAgainst(renderOnCpu(scene, small, precision), scene, closed), 2.0 * tessellation)
            << nameOf(precision);
}

TEST(CpuShading, APointLightOnTheSurfaceStaysFinite)
{
    Scene scene = sphereScene("hybrid");
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, small);
    const std::size_t middle = samples.count() / 2;
    scene.lights[0].kind = LightKind::Point;
    scene.lights[0].position = {samples.Px[middle], samples.Py[middle], samples.Pz[middle]};
    for (const Precision precision : precisions)
        for (const float channel : shadeSamples(samples, scene, precision).rgb)
            ASSERT_TRUE(std::isfinite(channel));
}

TEST(CpuShading, TheMirrorShowsAConstantSkyDimmed)
{
    Scene scene = sphereScene("mirror");
    scene.lights.clear();
    scene.surface.values["reflectance"] = {0.5};
    scene.environment.kind = EnvironmentKind::Constant;
    scene.environment.radiance = {0.25, 0.5, 1.0};
    const auto closed = [](const Vec3d&, const Vec3d&) { return Vec3d(0.125, 0.25, 0.5); };
    for (const Precision precision : precisions)
        EXPECT_EQ(worstAgainst(renderOnCpu(scene, small, precision), scene, closed), 0.0) << nameOf(precision);
}

TEST(CpuShading, BackgroundFillsTheUncoveredSamples)
{
    Scene scene = sphereScene("lambert");
    scene.lights.clear();
    scene.background.color = {0.5, 0.25, 1.0};
    const RenderSettings settings{64, 64, 4};
    const Image plain = renderOnCpu(scene, settings, Precision::Double);
    for (std::size_t pixel = 0; pixel < plain.pixels(); ++pixel)
        // Sixteenths and powers of two: exact.
        ASSERT_EQ(plain.rgb[3 * pixel], 0.5F * (1.0F - plain.coverage[pixel]));
    // The same colour as a constant environment must give the same picture, sample by sample.
    scene.background.kind = BackgroundKind::Environment;
    scene.environment.kind = EnvironmentKind::Constant;
    scene.environment.radiance = scene.background.color;
    EXPECT_EQ(renderOnCpu(scene, settings, Precision::Double).rgb, plain.rgb);
}

TEST(CpuShading, PrecisionsAgreeOnTheSameSamples)
{
    Scene scene = sphereScene("hybrid");
    scene.surface.values["n"] = {50.0};
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].kind = LightKind::Point;
    scene.lights[1].position = {-2.0, 1.0, 3.0};
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh), scene.camera, {96, 96, 2});
    const Image truth = shadeSamples(samples, scene, Precision::Double);
    // Light, K and ks are at most 1 here. A rounding of N, L or V turns R by a few 2^-24; the lobe's steepest slope is
    // sqrt(n / e) = 4.3 and the cosine's 1, for two lights: 2 * 32 * (4.3 + 1) * 2^-24.
    const double bound = 2.0 * 32.0 * 5.3 * 0x1p-24;
    for (const Precision precision : {Precision::Float, Precision::Simd}) {
        const Image image = shadeSamples(samples, scene, precision);
        for (std::size_t i = 0; i < truth.rgb.size(); ++i)
            ASSERT_NEAR(image.rgb[i], truth.rgb[i], bound) << nameOf(precision);
    }
}

TEST(CpuShading, OffLightsAndAnEmptySceneAreBlack)
{
    Scene scene = sphereScene("hybrid");
    scene.lights[0].on = false;
    for (const float channel : renderOnCpu(scene, small, Precision::Simd).rgb)
        ASSERT_EQ(channel, 0.0F);
}

TEST(CpuShading, OneThreadGivesTheSamePictureAsTwo)
{
    const Scene scene = sphereScene("hybrid");
    const RenderSettings settings{150, 130, 2};
    for (const Precision precision : precisions) {
        Image pictures[2];
        for (std::size_t threads = 1; threads <= 2; ++threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            pictures[threads - 1] = renderOnCpu(scene, settings, precision);
        }
        EXPECT_EQ(pictures[0].rgb, pictures[1].rgb) << nameOf(precision);
    }
}

TEST(CpuShading, TilesLeaveNoSeam)
{
    // The samples that are kept and those that are shaded at once; sizes that tiles and packets do not divide.
    Scene scene = sphereScene("hybrid", 16);
    scene.background.color = {0.5, 0.25, 1.0};
    for (const RenderSettings& settings :
         {RenderSettings{300, 20, 8}, RenderSettings{101, 67, 3}, RenderSettings{1, 1, 1}, RenderSettings{33, 35, 5}})
        for (const Precision precision : precisions) {
            const Image whole =
                shadeSamples(sampleView(*makeRayScene(scene.mesh), scene.camera, settings), scene, precision);
            const Image tiled = renderOnCpu(scene, settings, precision);
            EXPECT_EQ(tiled.rgb, whole.rgb) << nameOf(precision) << settings.width;
            EXPECT_EQ(tiled.coverage, whole.coverage);
        }
}

TEST(CpuShading, ReportsProgressAndStopsWhenAsked)
{
    const Scene scene = sphereScene("hybrid");
    Progress progress;
    static_cast<void>(renderOnCpu(scene, small, Precision::Double, &progress));
    // A sum of some hundred shares.
    EXPECT_NEAR(progress.done, 1.0, 1e-12);

    Progress stopped;
    stopped.cancel = true;
    const Image nothing = renderOnCpu(scene, small, Precision::Double, &stopped);
    EXPECT_TRUE(std::all_of(nothing.rgb.begin(), nothing.rgb.end(), [](float c) { return c == 0.0F; }));
}

TEST(RenderSettings, RefuseWhatCannotBeRendered)
{
    ASSERT_TRUE(checkedSettings(1, 16384, 64));
    EXPECT_EQ(checkedSettings(1, 16384, 64)->samplesPerAxis, 8);
    EXPECT_FALSE(checkedSettings(0, 100, 1));
    EXPECT_FALSE(checkedSettings(100, 16385, 1));
    EXPECT_FALSE(checkedSettings(100, 100, 5));
    EXPECT_FALSE(checkedSettings(100, 100, 81));
}

} // namespace
} // namespace reflectance::test
