// Measured tables in pictures: GL and the CPU agree, holes are painted, and a table is uploaded once.
#include "core/reflectance/evaluate.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/requirements.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <cmath>
#include <numbers>

namespace reflectance::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr RenderSettings small{96, 72, 1};

/// A smooth glossy surface over even angles; up to `end` degrees in theta.
Table glossy(AngleSystem system, std::size_t channels, double end)
{
    Table table;
    table.system = system;
    table.channels = channels;
    const auto steps = [](double last, int count) {
        std::vector<double> angles;
        for (int i = 0; i <= count; ++i)
            angles.push_back(last * i / count * pi / 180);
        return angles;
    };
    table.axes = {steps(end, 18), steps(end, 18)};
    if (system != AngleSystem::Polar)
        table.axes.push_back(steps(180.0, 12));
    for (const double a : table.axes[0])
        for (const double b : table.axes[1])
            for (std::size_t c = 0; c < (system == AngleSystem::Polar ? 1 : table.axes[2].size()); ++c)
                for (std::size_t k = 0; k < channels; ++k)
                    table.values.push_back(0.05 * static_cast<double>(1 + k) + 0.2 * std::exp(-4.0 * a * b) +
                                           0.02 *
                                               std::cos(system == AngleSystem::Polar ? 0.0 : 2.0 * table.axes[2][c]));
    return table;
}

Scene measuredScene(const Table& table)
{
    Scene scene = twoLightScene("table");
    scene.surface.table = measuredTable(table);
    scene.surface.tableFile = "made.csv";
    return scene;
}

bool isStriped(const float* rgb)
{
    return rgb[0] == 1.0F && rgb[1] == 0.0F;
}

struct Comparison {
    double worst = 0.0;
    int apart = 0; ///< pixels further apart than rounding explains
    int covered = 0, bright = 0, striped = 0;
};

/// A pixel may stand on the edge of a hole or of a stripe, where rounding decides; elsewhere values run by 2 over 0.09 rad at
/// most, and angles are off by 1e-6.
constexpr double allowed = 1e-4;

class GlTables : public GlTest {
protected:
    Comparison compare(const Scene& scene)
    {
        render(scene, small);
        const Image gl = renderer().readLinear();
        const Image cpu = shadeSamples(renderer().readSamples(), scene, Precision::Double);
        Comparison found;
        for (int y = 0; y < gl.height; ++y)
            for (int x = 0; x < gl.width; ++x) {
                double worst = 0.0;
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst, std::fabs(double{gl.at(x, y)[c]} - double{cpu.at(x, y)[c]}));
                const bool covered = gl.coverage[static_cast<std::size_t>(y * gl.width + x)] > 0.0F;
                found.covered += covered;
                found.bright += covered && gl.at(x, y)[0] > 0.02F;
                found.striped += isStriped(gl.at(x, y));
                found.apart += worst > allowed;
                if (worst <= allowed)
                    found.worst = std::max(found.worst, worst);
            }
        return found;
    }
};

TEST_P(GlTables, AgreeWithTheCpuInEverySystemAndInterpolation)
{
    for (const AngleSystem system : {AngleSystem::Polar, AngleSystem::Isotropic, AngleSystem::HalfDifference})
        for (const std::size_t channels : {1U, 3U, 9U})
            for (const Interpolation between : {Interpolation::Linear, Interpolation::MonotoneCubic}) {
                Table table = glossy(system, channels, 90.0);
                table.interpolation = between;
                const Comparison found = compare(measuredScene(table));
                EXPECT_GT(found.bright, 500) << nameOf(system) << ' ' << channels;
                EXPECT_LE(found.apart, 2) << nameOf(system) << ' ' << channels << ' ' << nameOf(between);
            }
}

TEST_P(GlTables, FloatAndLanesAgreeWithDoubleToo)
{
    const Scene scene = measuredScene(glossy(AngleSystem::HalfDifference, 3, 90.0));
    render(scene, small);
    const ViewSamples samples = renderer().readSamples();
    const Image truth = shadeSamples(samples, scene, Precision::Double);
    for (const Precision precision : {Precision::Float, Precision::Simd}) {
        const Image image = shadeSamples(samples, scene, precision);
        int apart = 0;
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            apart += std::fabs(image.rgb[i] - truth.rgb[i]) > allowed;
        EXPECT_LE(apart, 3) << nameOf(precision);
    }
}

TEST_P(GlTables, HolesAreBlackUnlessTheyAreToBeSeen)
{
    Scene scene = measuredScene(glossy(AngleSystem::Isotropic, 3, 45.0));
    EXPECT_EQ(compare(scene).striped, 0);
    scene.surface.showHoles = true;
    const Comparison found = compare(scene);
    EXPECT_GT(found.striped, 200) << "beyond 45 degrees";
    EXPECT_LE(found.apart, found.covered / 100) << "edges of holes and stripes alone";
    // A table without holes wears no stripes.
    scene.surface.table = measuredTable(glossy(AngleSystem::Isotropic, 3, 90.0));
    EXPECT_EQ(compare(scene).striped, 0);
}

TEST_P(GlTables, AreUploadedOnceHoweverTheLightMoves)
{
    Scene scene = measuredScene(glossy(AngleSystem::Isotropic, 3, 90.0));
    render(scene, small);
    EXPECT_EQ(renderer().work().tableUploads, 1U);
    scene.lights[0].direction.x += 0.2;
    render(scene, small);
    scene.surface.model = "lambert";
    render(scene, small);
    scene.surface.model = "table";
    render(scene, small);
    EXPECT_EQ(renderer().work().tableUploads, 1U);
    scene.surface.table = measuredTable(glossy(AngleSystem::Polar, 1, 90.0));
    render(scene, small);
    EXPECT_EQ(renderer().work().tableUploads, 2U);
}

TEST_P(GlTables, WithoutAMeasurementTheSurfaceIsBlack)
{
    Scene scene = twoLightScene("table");
    const Comparison found = compare(scene);
    EXPECT_EQ(found.bright, 0);
    EXPECT_EQ(found.apart, 0);
    EXPECT_EQ(leftOut(scene).front(), "surface: no measurement is loaded, so it is black");
}

TEST_P(GlTables, EvaluateLooksThemUp)
{
    Table table = glossy(AngleSystem::Polar, 9, 90.0);
    const auto measured = measuredTable(table);
    const Model& model = **findModel("table");
    const Observation row{{0, 0, 2}, directionAt(0.4, 2.0), {{directionAt(0.7, 1.0), {1.0, 0.5, 0.25}, 0.0}}};
    const Vec3d expected =
        pi * std::cos(0.7) * lookedUp(table, {0, 0, 1}, directionAt(0.7, 1.0), directionAt(0.4, 2.0), row.lights[0].I);
    const auto got = renderer().evaluate(model, {}, {&row, 1}, measured);
    ASSERT_TRUE(got) << got.error().sentence();
    // A few roundings of pi f cos I, and of the angles.
    EXPECT_LE(length((*got)[0] - expected), 1e-5);
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd}) {
        const auto here = evaluate(model, {}, {&row, 1}, precision, lookUpsIn(measured.get()));
        EXPECT_LE(length(here[0] - expected), precision == Precision::Double ? 1e-15 : 1e-5) << nameOf(precision);
    }
}

IN_EVERY_CONTEXT(GlTables);

} // namespace
} // namespace reflectance::test
