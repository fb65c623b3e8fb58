// Leaving out what is 0 changes no value: the special form of every model equals the general one by ==, so that -0 is 0.
#include "core/reflectance/required_model.h"

#include "core/math/directions.h"
#include "core/reflectance/shade_block.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace reflectance {
namespace {

constexpr int scenes = 10'000;
constexpr std::size_t rows = 8;

class RandomScenes {
public:
    explicit RandomScenes(unsigned seed) : engine_(seed) {}

    /// Every parameter of its own: within its slider, 0 where that is legal, a colour or a diagonal of one number.
    std::vector<double> values(const ModelText& model)
    {
        std::vector<double> all(model.valueCount(), 0.0);
        for (const Parameter& p : model.parameters)
            fill(p, std::span(all).subspan(p.offset, p.size));
        return all;
    }

    /// Directions anywhere, viewers behind the surface and lights below it included; lights of any finite colour, black too.
    template <class T> void directions(ShadeBlock<T>& block)
    {
        for (std::size_t i = 0; i < rows; ++i) {
            const Vec3d N = direction();
            const Vec3d L = direction();
            block.N.set(i, N);
            block.L.set(i, L);
            block.V.set(i, i % 3 == 0 ? normalized(mirrored(N, L) + 0.1 * direction()) : direction());
            block.I.set(i, one(4) ? Vec3d(0.0, share(), -share()) : Vec3d(share(), 10.0 * share(), 1e4 * share()));
            block.lightDisc[i] = static_cast<T>(share());
        }
    }

private:
    double share() { return std::uniform_real_distribution<double>()(engine_); }
    bool one(int of) { return std::uniform_int_distribution<int>(1, of)(engine_) == 1; }
    Vec3d direction()
    {
        std::normal_distribution<double> gauss;
        return normalized({gauss(engine_), gauss(engine_), gauss(engine_)});
    }
    double number(const Parameter& p)
    {
        if (p.legalMin <= 0.0 && one(6))
            return 0.0;
        return p.sliderMin + share() * (p.sliderMax - p.sliderMin);
    }
    void fill(const Parameter& p, std::span<double> numbers)
    {
        const bool zero = p.legalMin <= 0.0 && p.choices.empty() && one(4);
        const bool grey = one(3);
        const bool diagonal = p.kind == ParameterKind::Matrix && one(2);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = p.choices.empty() ? number(p) : p.choices.front();
            if (p.kind == ParameterKind::Matrix && (grey || diagonal) && i % 4 != 0)
                numbers[i] = 0.0;
            else if (grey && p.kind != ParameterKind::List)
                numbers[i] = numbers[0];
            if (zero)
                numbers[i] = 0.0;
        }
    }

    std::mt19937 engine_;
};

template <class T>
bool same(const Kernel<T>& general, const std::vector<double>& values, const Kernel<T>& special,
          const std::vector<double>& required, ShadeBlock<T>& block)
{
    block.sum.fill({});
    general.shade(values.data(), block.batch(rows));
    const Vec3Column<T> expected = block.sum;
    block.sum.fill({});
    special.shade(required.data(), block.batch(rows));
    for (std::size_t i = 0; i < rows; ++i)
        if (!(expected[i] == block.sum[i]))
            return false;
    return true;
}

struct Findings {
    int different = 0;
    std::map<std::string, int> met; ///< how often each special form came up
};

/// Random scenes of all models; `require` is what is on trial.
template <class T, class Require> Findings findings(Kernel<T> Kernels::*precision, const Require& require)
{
    RandomScenes random(11);
    Findings found;
    ShadeBlock<T> block;
    for (int scene = 0; scene < scenes; ++scene) {
        const Model& model = catalogue()[static_cast<std::size_t>(scene) % catalogue().size()];
        const std::vector<double> values = random.values(model.text);
        random.directions(block);
        const RequiredModel required = require(model, values);
        const Kernels& special = required.model->with(required.form);
        if (&special != &model)
            ++found.met[required.model->id() + required.form.key()];
        found.different += same(model.*precision, values, special.*precision, required.values, block) ? 0 : 1;
    }
    return found;
}

TEST(RequiredModel, EqualsTheModelInDoubleOnTenThousandScenes)
{
    const Findings found = findings(&Kernels::exact, requiredModel);
    EXPECT_EQ(found.different, 0);
    for (const Model& model : catalogue()) // nothing that has kernels of its own went untried
        for (const auto& special : model.specials)
            EXPECT_GT(found.met.count(model.id() + special.first.key()), 0U) << model.id() << special.first.key();
    EXPECT_GT(found.met.at("lambert"), 0);
    EXPECT_GT(found.met.at("phong"), 0);
}

/// The same operations are left out, so that rounding is the same too.
TEST(RequiredModel, EqualsTheModelInFloatAndLanes)
{
    EXPECT_EQ(findings(&Kernels::single, requiredModel).different, 0);
    EXPECT_EQ(findings(&Kernels::lanes, requiredModel).different, 0);
}

/// The planted faults: a limit taken for viewers behind the surface too, and a K taken for grey that is not.
TEST(RequiredModel, TheTrialCatchesWhatIsNotEqual)
{
    const auto forgetful = [](const Model& model, std::span<const double> values) {
        RequiredModel required = requiredModel(model, values);
        required.form.facing = false;
        return required;
    };
    const auto careless = [](const Model& model, std::span<const double> values) {
        RequiredModel required = requiredModel(model, values);
        if (required.form.K == MatrixForm::Diagonal && required.model->id() == "hybrid")
            required.form.K = MatrixForm::Grey;
        return required;
    };
    EXPECT_GT(findings(&Kernels::exact, forgetful).different, 10);
    EXPECT_GT(findings(&Kernels::exact, careless).different, 10);
}

std::string runs(const std::string& model, const ParameterValues& values)
{
    const Model& found = **findModel(model);
    const RequiredModel required = requiredModel(found, flatValues(found.text, values));
    return required.model->id() + required.form.key();
}

TEST(RequiredModel, FollowsLimitsAsFarAsTheyGo)
{
    EXPECT_EQ(runs("hybrid", {}), "hybrid+one");
    EXPECT_EQ(runs("hybrid", {{"ks", {0.1, 0.2, 0.3}}}), "hybrid");
    EXPECT_EQ(runs("hybrid", {{"ks", {0.0}}}), "lambert_color");
    EXPECT_EQ(runs("hybrid", {{"ks", {0.0}}, {"K", {0.1, 0.2, 0.3}}}), "lambert_color+diagonal");
    EXPECT_EQ(runs("hybrid", {{"ks", {0.0}}, {"K", {0.5}}}), "lambert");
    EXPECT_EQ(runs("hybrid", {{"K", {0.5}}}), "hybrid+grey+one");
    EXPECT_EQ(runs("hybrid", {{"K", {0.0}}}), "phong+one");
    EXPECT_EQ(runs("blinn_phong", {}), "blinn_phong+black+one");
    EXPECT_EQ(runs("oren_nayar", {}), "oren_nayar");
    EXPECT_EQ(runs("oren_nayar", {{"sigma", {0.0}}}), "lambert_color+diagonal+facing");
    EXPECT_EQ(runs("oren_nayar", {{"sigma", {0.0}}, {"rho", {0.6}}}), "lambert+facing");
    EXPECT_EQ(runs("ward", {{"ks", {0.0}}, {"K", {1, 2, 3, 4, 5, 6, 7, 8, 9}}}), "lambert_color+facing");
    EXPECT_EQ(runs("mirror", {}), "mirror");
}

/// (rho x) I is not rho I x to the last bit, so these texts promise no equality and stay.
TEST(RequiredModel, LeavesAloneWhatIsOnlyNearlyEqual)
{
    EXPECT_EQ(runs("eon", {{"r", {0.0}}}), "eon");
    EXPECT_EQ(runs("oren_nayar_full", {{"sigma", {0.0}}}), "oren_nayar_full");
}

TEST(RequiredModel, SaysWhatItLeavesOut)
{
    const Model& hybrid = **findModel("hybrid");
    const auto leftOut = requiredModel(hybrid, flatValues(hybrid.text, {{"ks", {0.0}}, {"K", {0.5}}})).leftOut;
    ASSERT_EQ(leftOut.size(), 2U);
    EXPECT_EQ(leftOut[0], "hybrid where ks=0: computed as lambert_color");
    EXPECT_EQ(leftOut[1], "lambert_color where K=kd: computed as lambert");
    EXPECT_TRUE(generalModel(hybrid, flatValues(hybrid.text, {})).leftOut.empty());
}

} // namespace
} // namespace reflectance
