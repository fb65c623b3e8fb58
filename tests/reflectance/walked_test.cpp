// Texts that are walked: every built-in text gives what its compiled kernel gives, bit for bit, and what a text may get
// wrong is said with its line.
#include "core/reflectance/evaluate.h"
#include "core/reflectance/own_model.h"
#include "core/reflectance/shade_block.h"
#include "core/reflectance/walked/walker.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace reflectance {
namespace {

/// A stand-in for a measured table: any function of all four will do.
template <class T> Vec3<T> lookUp(const void*, const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I)
{
    return (dot(N, V) + dot(L, V)) * I;
}

template <class T> Vec3<T> sky(const void*, const Vec3<T>& d)
{
    return {d.x, d.y * d.y, d.z + lit<T>(1.0)};
}

class Chance {
public:
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    Vec3d direction() { return normalized(Vec3d(between(-1, 1), between(-1, 1), between(-1, 1))); }

    ParameterValues valuesFor(const ModelText& text)
    {
        ParameterValues values;
        for (const Parameter& p : text.parameters) {
            if (p.kind == ParameterKind::List)
                continue;
            std::vector<double>& numbers = values[p.name];
            for (std::size_t i = 0; i < p.size; ++i)
                numbers.push_back(p.choices.empty() ? between(p.sliderMin, p.sliderMax)
                                                    : p.choices[random_() % p.choices.size()]);
        }
        for (const Parameter& p : text.parameters)
            if (p.kind == ParameterKind::List) {
                std::vector<double>& numbers = values[p.name];
                numbers.resize(p.formFor(values[p.chosenBy][0])->names.size());
                for (double& number : numbers)
                    number = between(-1, 1);
            }
        return values;
    }

private:
    std::mt19937_64 random_{7};
};

template <class T> void fill(ShadeBlock<T>& block, Chance& chance)
{
    for (std::size_t i = 0; i < blockSize; ++i) {
        // Every fourth L stands at N or opposite to V, where texts take their other branches.
        const Vec3d N = chance.direction(), V = chance.direction();
        block.N.set(i, N);
        block.V.set(i, V);
        block.L.set(i, i % 8 == 0 ? N : i % 8 == 4 ? -V : chance.direction());
        block.I.set(i, {chance.between(0, 2), chance.between(0, 2), chance.between(0, 2)});
        block.lightDisc[i] = static_cast<T>(chance.between(0, 4));
    }
    block.sum.fill({});
}

template <class T> bool sameBits(const Vec3<T>& a, const Vec3<T>& b)
{
    const auto same = [](T x, T y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// Rows that differ, of 40 blocks with random parameters.
template <class T> std::size_t differences(const Model& model, const Kernel<T>& compiled, const Kernel<T>& walked)
{
    Chance chance;
    std::size_t count = 0;
    for (int round = 0; round < 40; ++round) {
        const auto values = flatValues(model.text, chance.valuesFor(model.text));
        ShadeBlock<T> a;
        fill(a, chance);
        ShadeBlock<T> b = a;
        for (const auto& [block, kernel] : {std::pair(&a, &compiled), std::pair(&b, &walked)}) {
            ShadeBatch<T> batch = block->batch(blockSize);
            batch.measured = {lookUp<T>, nullptr};
            kernel->shade(values.data(), batch);
            if (kernel->environment)
                kernel->environment(values.data(), block->environmentBatch(blockSize, {sky<T>, nullptr}));
        }
        for (std::size_t i = 0; i < blockSize; ++i)
            count += sameBits(a.sum[i], b.sum[i]) ? 0U : 1U;
    }
    return count;
}

TEST(Walked, EveryBuiltInTextGivesWhatItsKernelGives)
{
    for (const Model& model : catalogue()) {
        const auto walked = walkedModel(model.text);
        ASSERT_TRUE(walked) << walked.error().sentence();
        EXPECT_EQ(walked->exact.environment != nullptr, model.exact.environment != nullptr) << model.id();
        EXPECT_EQ(differences<double>(model, model.exact, walked->exact), 0U) << model.id();
        EXPECT_EQ(differences<float>(model, model.single, walked->single), 0U) << model.id();
    }
}

TEST(Walked, TheComparisonCatchesAPlantedFault)
{
    const Model& lambert = **findModel("lambert");
    ModelText changed = lambert.text;
    const std::size_t at = changed.code.find("kd");
    ASSERT_NE(at, std::string::npos);
    changed.code.replace(at, 2, "(1.0000000000000002 * kd)"); // the last bit
    EXPECT_GT(differences<double>(lambert, lambert.exact, walkedModel(changed)->exact), 0U);
}

Vec3d valueOf(const std::string& body)
{
    const auto model = ownModel("mine.glsl", "uniform float k = 2.0;\n" + body);
    EXPECT_TRUE(model) << model.error().sentence();
    if (!model)
        return {};
    return evaluate(**model, flatValues((*model)->text, {}),
                    std::vector<Observation>{{{0, 0, 1}, {0.6, 0, 0.8}, {{{0, 0.6, 0.8}, {1, 2, 3}, 0}}}},
                    Precision::Double)[0];
}

std::string shade(const std::string& statements)
{
    return "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n" + statements + "\n}\n";
}

TEST(Walked, TextsBranchLoopAndCall)
{
    EXPECT_EQ(valueOf(shade("if (N.z > 0.5) { return I; } else return vec3(0.0);")), Vec3d(1, 2, 3));
    EXPECT_EQ(valueOf(shade("float s = 0.0; for (int i = 0; i < 4; i++) s += float(i); return vec3(s);")), Vec3d(6.0));
    EXPECT_EQ(valueOf(shade("vec3 a[3]; for (int i = 2; i >= 0; --i) a[i] = float(i) * I; return a[1] + a[2];")),
              Vec3d(3, 6, 9));
    EXPECT_EQ(valueOf(shade("vec3 a = I; a.y = 7.0; a.x *= k; return a;")), Vec3d(2, 7, 3));
    EXPECT_EQ(valueOf("const float two = 1.0 + 1.0;\nfloat f(float a, float b) { return a * two - b; }\n"
                      "bool one(int i) { return i / 1 == 1; }\n" +
                      shade("return vec3(f(f(1.0, 2.0), f(3.0, 1.0)), !(1 > 2) && one(1) && true ? k : 0.0, -N.z);")),
              Vec3d(-5, 2, -1));
}

/// Hidden names: an inner block's variable is another one.
TEST(Walked, ScopesHide)
{
    EXPECT_EQ(valueOf(shade("float a = 1.0; { float a = 2.0; a = 3.0; } float b = a; return vec3(a, b, k);")),
              Vec3d(1, 1, 2));
}

TEST(Walked, WhatIsWrongIsSaidWithItsLine)
{
    struct Case {
        const char* text;
        long line;
        const char* says;
    };
    const Case cases[] = {
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    return kd * I;\n}\n", 3, "'kd' is not known"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    return 1.0 + I;\n}\n", 3, "do not go together"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return max(1, 0.0) * I; }\n", 1, "numbers with a point"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    return N.xyz;\n}\n", 3, "swizzles"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return shade(N, L, V, I); }\n", 1, "is not known"},
        {"float lobe(vec3 a, vec3 b, float c) { return 1.0; }\nvec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return I; "
         "}",
         1, "prelude"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { while (true) return I; }\n", 1, "a statement is"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { if (N.x > 0.0) return I; }\n", 1, "must end with a return"},
        {"#define A\nvec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return I; }\n", 1, "preprocessor"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    return I;\n", 3, "ends within"},
        {"vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { for (int i = 0; i < 2; ++i) i = 0; return I; }", 1,
         "cannot be changed"},
        {"uniform float k = 1.0;\nvec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { k = 2.0; return I; }", 2,
         "cannot be changed"},
    };
    for (const Case& c : cases) {
        const auto model = ownModel("mine.glsl", c.text);
        ASSERT_FALSE(model) << c.text;
        EXPECT_EQ(model.error().file, "mine.glsl");
        EXPECT_EQ(model.error().line, c.line) << c.text << model.error().sentence();
        EXPECT_NE(model.error().sentence().find(c.says), std::string::npos) << model.error().sentence();
    }
}

TEST(Walked, NothingRunsForeverOrTooDeep)
{
    const auto endless = ownModel("a.glsl", shade("for (int i = 0; i < 1; i += 0) {} return I;"));
    ASSERT_FALSE(endless);
    EXPECT_NE(endless.error().sentence().find("rounds"), std::string::npos);
    // Each function calls the last one twice: 2^40 calls.
    std::string doubling = "float f0(float a) { return a; }\n";
    for (int i = 1; i <= 40; ++i)
        doubling += "float f" + std::to_string(i) + "(float a) { return f" + std::to_string(i - 1) + "(a) + f" +
                    std::to_string(i - 1) + "(a); }\n";
    EXPECT_FALSE(ownModel("a.glsl", doubling + shade("return f40(1.0) * I;")));
    EXPECT_FALSE(ownModel("a.glsl", shade("return " + std::string(5000, '(') + "I" + std::string(5000, ')') + ";")));
    std::string sum = "0.0";
    for (int i = 0; i < 5000; ++i)
        sum += " + 1.0";
    EXPECT_FALSE(ownModel("a.glsl", shade("return vec3(" + sum + ");")));
    EXPECT_FALSE(ownModel("a.glsl", shade(std::string(5000, '{') + "return I;" + std::string(5000, '}'))));
}

TEST(OwnModel, TakesItsNameFromItsFile)
{
    const auto model = ownModel("/some/where/My Model-2.glsl", shade("return I;"));
    ASSERT_TRUE(model);
    EXPECT_EQ((*model)->id(), "my_model_2");
    EXPECT_EQ((*model)->text.name, "My Model-2");
    EXPECT_EQ((*ownModel("phong.glsl", shade("return I;")))->id(), "own_phong");
}

} // namespace
} // namespace reflectance
