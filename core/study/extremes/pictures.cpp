// H13, H40, H41, H60, H61 and H72 as pictures: what lies between the file and the pixel.
#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace reflectance {
namespace {

constexpr RenderSettings settings{65, 65, 1};

/// A wavy square of 2 x 2 as OBJ text, multiplied by scale, then moved by offset.
std::string waves(double scale, double offset)
{
    constexpr int last = 16;
    std::string text;
    for (int i = 0; i <= last; ++i)
        for (int j = 0; j <= last; ++j) {
            const double x = 2.0 * i / last - 1.0;
            const double y = 2.0 * j / last - 1.0;
            text += "v";
            for (const double c : {x, y, 0.3 * std::cos(3.0 * x) * std::cos(2.0 * y)})
                text += " " + shortest(c * scale + offset);
            text += '\n';
        }
    for (int i = 0; i < last; ++i)
        for (int j = 0; j < last; ++j) {
            const int corner = i * (last + 1) + j + 1;
            text += "f " + std::to_string(corner) + " " + std::to_string(corner + last + 1) + " " +
                    std::to_string(corner + last + 2) + " " + std::to_string(corner + 1) + "\n";
        }
    return text;
}

/// A square about the origin in the plane z = 0, seen straight on: the middle sample meets the origin.
Result<Scene> squareUnder(const Light& light)
{
    auto scene = sceneOfObj("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    if (!scene)
        return scene;
    scene->camera.eye = {0, 0, 3};
    scene->lights = {light};
    scene->surface = {"lambert", {{"kd", {1.0}}}};
    return scene;
}

Result<Scene> squareUnderALamp()
{
    Light lamp;
    lamp.kind = LightKind::Point;
    lamp.position = {0, 0, 1e-3};
    return squareUnder(lamp);
}

Result<Scene> squareUnderTheSun()
{
    Light far;
    far.kind = LightKind::Point;
    far.position = 1e15 * normalized(Vec3d(1, 2, 3));
    far.intensity = Vec3d(1e30);
    return squareUnder(far);
}

std::size_t nonFinite(const Image& image)
{
    return static_cast<std::size_t>(
        std::count_if(image.rgb.begin(), image.rgb.end(), [](float c) { return !std::isfinite(c); }));
}

/// The largest difference of two pictures in 8-bit codes.
int codesApart(const Image& a, const Image& b)
{
    const Developed left = develop(a, {});
    const Developed right = develop(b, {});
    int worst = 0;
    for (std::size_t i = 0; i < left.rgb.size(); ++i)
        worst = std::max(worst, std::abs(int{left.rgb[i]} - int{right.rgb[i]}));
    return worst;
}

float brightest(const Image& image)
{
    return *std::max_element(image.rgb.begin(), image.rgb.end());
}

const std::string badNormalsText = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn nan 0 1\nvn inf 0 0\nf 1//1 2//2 3//1\n";

Outcome badNormalsSeen(Bench& bench)
{
    const auto scene = sceneOfObj(badNormalsText);
    if (!scene)
        return {false, scene.error().sentence()};
    const Image image = bench.render(*scene, settings);
    return {nonFinite(image) == 0 && brightest(image) > 0.0F,
            std::to_string(nonFinite(image)) + " channels, brightest " + general(brightest(image), 3)};
}

Outcome samePicture(Bench& bench, const std::vector<std::pair<double, double>>& placements)
{
    const auto plain = sceneOfObj(waves(1.0, 0.0));
    if (!plain)
        return {false, plain.error().sentence()};
    const Image expected = bench.render(*plain, settings);
    int worst = 0;
    for (const auto& [scale, offset] : placements) {
        const auto scene = sceneOfObj(waves(scale, offset));
        if (!scene)
            return {false, scene.error().sentence()};
        worst = std::max(worst, codesApart(bench.render(*scene, settings), expected));
    }
    return {worst <= 1 && brightest(expected) > 0.1F, std::to_string(worst) + " codes apart"};
}

Outcome scaledMeshes(Bench& bench)
{
    return samePicture(bench, {{1e-6, 0.0}, {1e6, 0.0}});
}

Outcome offsetMesh(Bench& bench)
{
    return samePicture(bench, {{1.0, 1e6}});
}

Outcome lightOnTheSurface(Bench& bench)
{
    std::string found;
    bool holds = true;
    for (const double height : {0.0, 1e-30, 1e-20, 1e-3}) {
        Light light;
        light.kind = LightKind::Point;
        light.position = {0, 0, height};
        const auto scene = squareUnder(light);
        if (!scene)
            return {false, scene.error().sentence()};
        const Image image = bench.render(*scene, settings);
        const double r = std::max(height, smallestLightDistance);
        const double expected = height > 0.0 ? 1.0 / (r * r) : 0.0;
        // At no distance the light adds nothing; the samples beside it see it at grazing angles, which is nothing too.
        // Pictures hold floats; a few roundings lead there.
        const double allowed = 0x1p-20 * std::max(expected, 1.0);
        holds = holds && nonFinite(image) == 0 && std::fabs(brightest(image) - expected) <= allowed;
        found += (found.empty() ? "" : ", ") + general(brightest(image), 6);
    }
    return {holds, found};
}

/// A product of a subnormal albedo and a huge light: threads that flush subnormal numbers make it 0.
Outcome subnormalsInThreads(Bench& bench)
{
    Light light;
    light.direction = {0, 0, 1};
    light.intensity = Vec3d(bench.isDouble() ? 1e300 : 1e30);
    auto scene = squareUnder(light);
    if (!scene)
        return {false, scene.error().sentence()};
    scene->surface.values["kd"] = {bench.isDouble() ? 1e-310 : 1e-40};
    const double got = brightest(bench.render(*scene, settings));
    // 1e-40 is a float with 17 bits.
    return {std::fabs(got - 1e-10) <= 1e-14, general(got, 6)};
}

Outcome lightFarAway(Bench& bench)
{
    Light sun;
    sun.direction = {1, 2, 3};
    const Vec3d towards = normalized(sun.direction);
    const auto lit = squareUnder(sun);
    if (!lit)
        return {false, lit.error().sentence()};
    const Image expected = bench.render(*lit, settings);
    double worst = 0.0;
    for (const double distance : {1e3, 1e6, 1e9, 1e12, 1e15}) {
        Scene scene = *lit;
        scene.lights.front().kind = LightKind::Point;
        scene.lights.front().position = distance * towards;
        scene.lights.front().intensity = Vec3d(distance * distance);
        const Image image = bench.render(scene, settings);
        double apart = 0.0;
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            apart = worse(apart, std::fabs(double{image.rgb[i]} - double{expected.rgb[i]}));
        // Parallax 1/D, fall-off 2/D within the unit sphere; the picture is float, the arrival is rounded a few times.
        worst = worse(worst, apart / (4.0 / distance + 16.0 * std::max(bench.unit(), 0x1p-24)));
    }
    return {worst <= 1.0 && brightest(expected) > 0.5F, "differs by " + general(worst, 2) + " of the allowed"};
}

} // namespace

Hazards pictureHazards()
{
    return {
        {"H13",
         "a picture of normals that are no numbers",
         "a triangle with vn nan 0 1, vn inf 0 0",
         "0 channels not finite, and light",
         inEveryPrecision,
         {},
         badNormalsSeen,
         seenMesh(badNormalsText, "A triangle that shines as its face says: the file's normals are no numbers.")},
        {"H40",
         "a light on the surface",
         "a point light 0, 1e-30, 1e-20 and 1e-3 above a seen point",
         "0, 1e+12, 1e+12, 1e+06: r counts as 1e-6 at least",
         inEveryPrecision,
         {"lambert"},
         lightOnTheSurface,
         seenScene(squareUnderALamp, "A point light 1e-3 above the surface: 1e6 below it, and no pixel that is "
                                     "infinite. Lower the exposure to see it fall off.")},
        {"H41",
         "a light far away",
         "a point light at 1e3 .. 1e15, made as bright as a directional one",
         "as the directional one to 4/D",
         inEveryPrecision,
         {"lambert"},
         lightFarAway,
         seenScene(squareUnderTheSun, "A point light at 1e15, as bright as one without a place: the square is even.")},
        {"H60",
         "large and small meshes",
         "a mesh times 1e-6 and 1e6",
         "at most 1 code apart from times 1",
         inEveryPrecision,
         {},
         scaledMeshes,
         seenMesh(waves(1e-6, 0.0), "A mesh of 1e-6 of the usual size: it looks as any other.")},
        {"H61",
         "a mesh far from the origin",
         "a mesh moved by 1e6",
         "at most 1 code apart from unmoved",
         inEveryPrecision,
         {},
         offsetMesh,
         seenMesh(waves(1.0, 1e6), "A mesh that the file puts 1e6 away from the origin: its waves are smooth.")},
        {"H72",
         "threads that flush subnormal numbers",
         "Lambert, kd = 1e-310 under a light of 1e300; float: 1e-40, 1e30",
         "1e-10",
         {Precision::Double, Precision::Float, Precision::Simd},
         {"lambert"},
         subnormalsInThreads,
         unseen("The value is 1e-10, which no display tells from black.")},
    };
}

} // namespace reflectance
