// What a probe says is what the renderer computes there: the same point, the same numbers, the same code value.
#include "core/study/probe/probe.h"

#include "core/reflectance/evaluate.h"
#include "core/reflectance/own_model.h"
#include "core/reflectance/walked/terms.h"
#include "core/sensor/sensor.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace reflectance {
namespace {

constexpr int width = 96, height = 72;

/// Two lights of each kind, one of them off, and surroundings for those who look at them.
Scene sceneWith(const std::string& model)
{
    Scene scene = defaultScene();
    scene.surface.model = model;
    scene.environment.kind = EnvironmentKind::Studio;
    Light lamp;
    lamp.kind = LightKind::Point;
    lamp.position = {0.8, 1.5, 1.2};
    lamp.intensity = {1.5, 1.2, 0.7};
    lamp.angularRadius = 20.0;
    Light off = lamp;
    off.on = false;
    scene.lights.insert(scene.lights.begin(),
                        {off, lamp}); // before the directional ones, so that the order is not theirs
    return scene;
}

struct View {
    Scene scene;
    Image image;
};

View viewOf(const std::string& model)
{
    View view{sceneWith(model), {}};
    const RenderSettings settings{width, height, 1};
    view.image = shadeSamples(sampleView(*makeRayScene(view.scene.mesh), view.scene.camera, settings), view.scene,
                              Precision::Double);
    return view;
}

template <class See> int eachProbe(const View& view, See see)
{
    int seen = 0;
    for (int y = 4; y < height; y += 5)
        for (int x = 3; x < width; x += 5)
            if (const auto point = pointAt(*view.scene.mesh, view.scene.camera, x + 0.5, y + 0.5, width, height)) {
                see(probeAt(view.scene, *point), x, y);
                ++seen;
            }
    return seen;
}

TEST(Probe, IsWhatTheRendererComputes)
{
    for (const Model& model : catalogue()) {
        if (model.text.usesTable)
            continue;
        const View view = viewOf(model.id());
        const Developed developed = develop(view.image, view.scene.sensor);
        const int seen = eachProbe(view, [&](const Probe& probe, int x, int y) {
            const float* const drawn = view.image.at(x, y);
            // The picture is the double rounded once: no tolerance.
            EXPECT_EQ(static_cast<float>(probe.value.x), drawn[0]) << model.id();
            EXPECT_EQ(static_cast<float>(probe.value.y), drawn[1]) << model.id();
            EXPECT_EQ(static_cast<float>(probe.value.z), drawn[2]) << model.id();
            const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(int{probe.codes[i]}, int{developed.rgb[pixel + i]}) << model.id();
        });
        EXPECT_GT(seen, 40) << model.id();
    }
}

TEST(Probe, TheAccountEndsWithTheKernelsValue)
{
    for (const Model& model : catalogue()) {
        if (model.text.usesTable)
            continue;
        eachProbe(viewOf(model.id()), [&](const Probe& probe, int, int) {
            for (const ProbedLight& light : probe.lights) {
                EXPECT_TRUE(light.account.value == light.value) << model.id(); // bit for bit
                ASSERT_FALSE(light.account.lines.empty()) << model.id();
                EXPECT_EQ(light.account.lines.back().name, "returned");
                EXPECT_EQ(light.account.lines.back().numbers[0], light.value.x);
            }
        });
    }
}

/// Terms are added in the formula's order, with a factor or two outside of the sum: a few roundings of the largest.
TEST(Probe, TermsAddUp)
{
    int dissected = 0;
    for (const Model& model : catalogue()) {
        if (model.text.usesTable)
            continue;
        eachProbe(viewOf(model.id()), [&](const Probe& probe, int, int) {
            for (const ProbedLight& light : probe.lights) {
                if (light.terms.empty())
                    continue;
                ++dissected;
                Vec3d sum;
                double largest = 0.0;
                for (const ProbedTerm& term : light.terms) {
                    sum += term.value;
                    largest = std::fmax(largest, length(term.value));
                }
                EXPECT_LE(length(sum - light.value), 8.0 * 2.2e-16 * largest) << model.id();
            }
        });
    }
    EXPECT_GT(dissected, 1000);
}

TEST(Probe, HybridIsDiffuseAndSpecular)
{
    const ModelText& text = (*findModel("hybrid"))->text;
    const auto tree = walked::treeOf(text);
    const auto terms = walked::termsOf(*tree);
    ASSERT_EQ(terms.size(), 2U);
    EXPECT_EQ(terms[0].name, "diffuse");
    EXPECT_EQ(terms[0].source, "cosine * (K * I)");
    EXPECT_EQ(terms[1].name, "specular");
    // Without the highlight it is Lambert's in colour, as the text declares for ks = 0.
    const auto left = walkedModel(walked::withTerms(text, *tree, {true, false}));
    const Model& lambert = **findModel("lambert_color");
    const std::vector<Observation> rows{{{0, 0, 1}, {0.6, 0, 0.8}, {{{-0.6, 0.1, 0.8}, {1, 0.5, 0.25}, 0}}}};
    const auto K = valueOf(*text.find("K"), {});
    const auto a = evaluate(*left, flatValues(text, {}), rows, Precision::Double)[0];
    const auto b = evaluate(lambert, flatValues(lambert.text, {{"K", K}}), rows, Precision::Double)[0];
    EXPECT_NEAR(a.x, b.x, 1e-15); // the cosine is multiplied from the other side
    EXPECT_NEAR(a.y, b.y, 1e-15);
}

TEST(Probe, SaysWhichBranchWasTaken)
{
    Scene scene = defaultScene();
    scene.lights.resize(1);
    scene.lights[0].direction = {0, 0, 1};
    scene.camera.eye = {0, 0, 5};
    ProbedPoint point;
    point.N = {0, 0, 1};
    const std::string facing = probeText(probeAt(scene, point));
    EXPECT_NE(facing.find("gate: cosine = 1 > 0, open"), std::string::npos) << facing;
    EXPECT_NE(facing.find("> 1/2, exp(n log1p(-x))"), std::string::npos) << facing;
    EXPECT_NE(facing.find("K I, red: 0.62*1 + 0.05*0.97 + 0.02*0.92 = 0.6869"), std::string::npos) << facing;
    scene.lights[0].direction = {0, 1, 1};
    scene.camera.eye = {0, 5, 1};
    EXPECT_NE(probeText(probeAt(scene, point)).find("so 0"), std::string::npos);
    scene.lights[0].direction = {0, 1, -1};
    EXPECT_NE(probeText(probeAt(scene, point)).find("is not above 0, closed"), std::string::npos);
}

TEST(Probe, MissesBesideTheObject)
{
    const View view = viewOf("lambert");
    EXPECT_FALSE(pointAt(*view.scene.mesh, view.scene.camera, 0.5, 0.5, width, height));
}

bool samePoint(const std::optional<ProbedPoint>& a, const std::optional<ProbedPoint>& b)
{
    if (!a || !b)
        return !a && !b;
    return a->triangle == b->triangle && a->P == b->P && a->N == b->N;
}

/// The mesh with its triangles in another order, neighbours far apart.
std::shared_ptr<const Mesh> shuffled(const Mesh& mesh)
{
    auto other = std::make_shared<Mesh>(mesh);
    std::shuffle(other->triangles.begin(), other->triangles.end(), std::mt19937(3));
    return other;
}

TEST(Probe, LooksOnlyNearTheRayAndFindsTheSamePoint)
{
    const Scene scene = defaultScene();
    Camera inside = scene.camera;
    inside.eye = {0.05, 0.0, 0.1};
    Camera far = scene.camera;
    far.eye = 20.0 * far.eye;
    far.fieldOfView = 2.0;
    for (const auto& mesh : {scene.mesh, shuffled(*scene.mesh)})
        for (const Camera& camera : {scene.camera, inside, far}) {
            int met = 0;
            for (double y = 4.5; y < height; y += 5.0)
                for (double x = 3.5; x < width; x += 5.0) {
                    const auto point = pointAt(*mesh, camera, x, y, width, height);
                    EXPECT_TRUE(samePoint(pointAt(mesh, camera, x, y, width, height), point)) << x << ' ' << y;
                    met += point ? 1 : 0;
                    if (point) {
                        EXPECT_FALSE(samePoint(pointAt(mesh, camera, x + 1.0, y, width, height), point))
                            << "the planted fault: a pixel to the side";
                    }
                }
            EXPECT_GT(met, 0);
        }
}

TEST(Probe, CsvHasARowForEachLight)
{
    const View view = viewOf("phong");
    const auto point = pointAt(*view.scene.mesh, view.scene.camera, 48.0, 36.0, width, height);
    ASSERT_TRUE(point);
    const std::string csv = probeCsv({probeAt(view.scene, *point)});
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4); // a header and the three lights that are on
    const auto commas = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
    EXPECT_EQ(commas(csv.substr(0, csv.find('\n'))), 30);
    EXPECT_EQ(commas(csv), 4 * 30);
    Probe named = probeAt(view.scene, *point);
    named.name = "2 B";
    EXPECT_NE(probeCsv({named}).find("\n2 B,48,36,Phong,"), std::string::npos);
}

} // namespace
} // namespace reflectance
