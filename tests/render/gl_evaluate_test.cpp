// `eval` in GLSL: any number of rows and lights, in chunks that must not show.
#include "core/reflectance/evaluate.h"
#include "tests/render/gl_fixture.h"

#include <cmath>

namespace reflectance::test {
namespace {

class GlEvaluate : public GlTest {
protected:
    std::vector<Vec3d> evaluated(const std::string& model, std::span<const Observation> rows)
    {
        const Model& m = **findModel(model);
        auto got = renderer().evaluate(m, flatValues(m.text, {}), rows);
        EXPECT_TRUE(got) << got.error().sentence();
        return got ? *std::move(got) : std::vector<Vec3d>();
    }
};

Observation lit(double angle, std::size_t lights)
{
    Observation row{{0, 0, 1}, {0.1, 0.2, 1}, {}};
    for (std::size_t i = 0; i < lights; ++i) {
        const double turn = angle + 0.1 * static_cast<double>(i);
        row.lights.push_back({{std::sin(turn), 0, std::cos(turn)}, {1, 2, 3}, 0.0});
    }
    return row;
}

TEST_P(GlEvaluate, NoRowsGiveNoValues)
{
    EXPECT_TRUE(evaluated("hybrid", {}).empty());
}

TEST_P(GlEvaluate, ARowWithoutLightOrDirectionIsBlack)
{
    const std::vector<Observation> rows{{{0, 0, 1}, {0, 0, 1}, {}},
                                        {{0, 0, 0}, {0, 0, 1}, {{{0, 0, 1}, {1, 1, 1}}}},
                                        {{0, 0, 1}, {0, 0, 0}, {{{0, 0, 1}, {1, 1, 1}}}},
                                        {{0, 0, 1}, {0, 0, 1}, {{{0, 0, 0}, {1, 1, 1}}}}};
    EXPECT_EQ(evaluated("hybrid", rows), std::vector<Vec3d>(4));
}

TEST_P(GlEvaluate, TheLengthOfVectorsDoesNotMatter)
{
    const Observation plain{{0, 0.6, 0.8}, {0, 0, 1}, {{{0.6, 0, 0.8}, {1, 1, 1}}}};
    const Observation scaled{{0, 0.6e200, 0.8e200}, {0, 0, 5e-324}, {{{0.6e-300, 0, 0.8e-300}, {1, 1, 1}}}};
    EXPECT_EQ(evaluated("hybrid", {{plain}}), evaluated("hybrid", {{scaled}}));
}

TEST_P(GlEvaluate, LightsAddUpInTheirOrderInFloat)
{
    const Observation row = lit(-0.9, 17);
    Vec3f sum;
    for (const ObservedLight& light : row.lights)
        sum += Vec3f(evaluated("hybrid", {{{row.N, row.V, {light}}}}).front());
    EXPECT_EQ(evaluated("hybrid", {{row}}).front(), Vec3d(sum));
}

TEST_P(GlEvaluate, ChunksDoNotShow)
{
    std::vector<Observation> rows; // 3 pairs each: a row's lights fall into two chunks of 131072
    for (std::size_t i = 0; i < 100'000; ++i)
        rows.push_back(lit(-1.2 + 2e-5 * static_cast<double>(i), 3));
    const std::vector<Vec3d> all = evaluated("hybrid", rows);
    ASSERT_EQ(all.size(), rows.size());
    for (const std::size_t i : {0UL, 1UL, 43'690UL, 43'691UL, 87'381UL, 99'999UL})
        EXPECT_EQ(all[i], evaluated("hybrid", {{rows[i]}}).front()) << i;
    EXPECT_NE(all[0], all[99'999]);
}

/// Both sides see the light's disc, open at its rim.
TEST_P(GlEvaluate, AMirrorSeesALightOfItsRadius)
{
    const auto seen = [&](double degrees, double radius) {
        const double angle = degrees * 3.14159265358979 / 180.0;
        return evaluated("mirror", {{{{0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, {{{0, 0, 1}, {1, 1, 1}, radius}}}}})
            .front()
            .x;
    };
    EXPECT_FLOAT_EQ(static_cast<float>(seen(1.999, 2.0)), 0.9F);
    EXPECT_EQ(seen(2.001, 2.0), 0.0);
    EXPECT_EQ(seen(0.0, 0.0), 0.0);
}

IN_EVERY_CONTEXT(GlEvaluate);

} // namespace
} // namespace reflectance::test
