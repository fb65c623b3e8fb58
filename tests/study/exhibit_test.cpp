// Every hazard can be looked at or says why not, and the middle of its picture is the very case.
#include "core/study/extremes/exhibit.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/study/extremes/extremes.h"
#include "core/study/extremes/hazard.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace reflectance::test {
namespace {

std::vector<Finding> everyRow()
{
    std::vector<Finding> rows;
    std::set<std::size_t> seen;
    Instruments instruments = programInstruments(nullptr, "not asked");
    // What is found does not matter here: nothing is computed.
    instruments.evaluate = [](const Model&, std::span<const double>, std::span<const Observation>, Precision) {
        return Result<std::vector<Vec3d>>(Error{"not asked"});
    };
    instruments.render = [](const Scene&, const RenderSettings&, Precision) {
        return Result<Image>(Error{"not asked"});
    };
    for (const Finding& finding : runExtremes(instruments))
        if (seen.insert(finding.hazard).second)
            rows.push_back(finding);
    return rows;
}

TEST(Exhibits, EveryRowHasAPictureOrAReason)
{
    std::size_t pictures = 0;
    for (const Finding& row : everyRow()) {
        const Exhibit exhibit = exhibitOf(row);
        EXPECT_GT(exhibit.caption.size(), 20U) << row.id << ' ' << row.danger;
        EXPECT_EQ(exhibit.caption.back(), '.') << row.id << ' ' << row.danger << ": " << exhibit.caption;
        pictures += exhibit.scene ? 1 : 0;
        if (exhibit.scene) {
            EXPECT_TRUE(exhibit.scene->mesh) << row.id;
            EXPECT_TRUE(row.verdict == Verdict::NotYet || findModel(exhibit.scene->surface.model)) << row.id;
        }
    }
    EXPECT_GT(pictures, 30U);
}

TEST(Exhibits, APictureOfAQuestionHasItInTheMiddle)
{
    Question question{"phong", {{"ks", {1.0}}, {"n", {1e6}}}};
    question.N = normalized(Vec3d(2, 3, 6));
    question.L = normalized(Vec3d(1, 4, 5));
    question.V = normalized(2.0 * dot(question.N, question.L) * question.N - question.L);
    for (const double n : {20.0, 1e6}) { // on a sphere, on a square
        question.parameters["n"] = {n};
        const Scene scene = *seen(question, "Here.")().scene;
        const ViewSamples view = sampleView(*makeRayScene(scene.mesh), scene.camera, {65, 65, 1});
        const std::size_t middle = 32 * 65 + 32;
        const std::uint32_t sample = view.firstOfPixel[middle];
        ASSERT_EQ(view.firstOfPixel[middle + 1], sample + 1);
        const Vec3d N{view.Nx[sample], view.Ny[sample], view.Nz[sample]};
        const Vec3d P{view.Px[sample], view.Py[sample], view.Pz[sample]};
        // The stock sphere's triangles cut corners by a part in a thousand; the square is exact.
        const double allowed = n > 1e3 ? 1e-12 : 5e-3;
        EXPECT_LE(length(N - question.N), allowed) << n;
        EXPECT_LE(length(normalized(view.eye - P) - question.V), allowed) << n;
        const Image image = shadeSamples(view, scene, Precision::Double);
        EXPECT_NEAR(image.at(32, 32)[0], 1.0F, 1e-3F) << "the peak, n = " << n;
    }
}

TEST(Exhibits, WhatTheSensorGetsIsSeenAsARamp)
{
    const Scene scene = *seenRadiance([](double x, double) { return x; }, "A ramp.")().scene;
    const Image image = renderOnCpu(scene, {129, 97, 1}, Precision::Double);
    EXPECT_NEAR(image.at(64, 48)[0], 0.5F, 0.02F);
    EXPECT_LT(image.at(40, 48)[0], image.at(64, 48)[0]);
    EXPECT_LT(image.at(64, 48)[0], image.at(90, 48)[0]);
}

/// The planted fault: a mesh that cannot be read gives the reader's sentence, not an empty picture.
TEST(Exhibits, ABrokenCaseSaysSo)
{
    const Exhibit exhibit = seenMesh("v 0 0\nf 1 2 3\n", "Never seen.")();
    EXPECT_FALSE(exhibit.scene);
    EXPECT_NE(exhibit.caption.find("extreme.obj"), std::string::npos) << exhibit.caption;
}

} // namespace
} // namespace reflectance::test
