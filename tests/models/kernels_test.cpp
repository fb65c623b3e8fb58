// The kernels themselves: instruction sets agree, and a batch's length never changes a value.
#include "core/math/angle.h"
#include "core/reflectance/kernel_tables.h"
#include "core/reflectance/shade_block.h"
#include "tests/models/evaluated.h"
#include "tests/models/random_cases.h"

#include <array>
#include <cstring>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

struct Lanes {
    const char* name;
    const Kernel<float>* kernels;
};

/// Those that this processor runs; the widest comes last.
std::vector<Lanes> lanesHere()
{
    std::vector<Lanes> all{{"sse2", lanesKernelsSse2().models}};
    if (std::strcmp(lanesName(), "avx2") == 0)
        all.push_back({"avx2", lanesKernelsAvx2().models});
    return all;
}

/// Cases that share one set of parameters, as a batch does.
std::vector<OracleCase> batchOf(const std::string& model, std::size_t count)
{
    std::vector<OracleCase> cases = randomCases(model, count);
    for (OracleCase& c : cases)
        c.parameters = cases[1].parameters;
    return cases;
}

template <class T> void load(const std::vector<OracleCase>& cases, ShadeBlock<T>& block)
{
    for (std::size_t i = 0; i < cases.size(); ++i) {
        block.N.set(i, normalized(cases[i].N));
        block.L.set(i, normalized(cases[i].L));
        block.V.set(i, normalized(cases[i].V));
        block.I.set(i, cases[i].I);
        block.lightDisc[i] = static_cast<T>(squaredChord(cases[i].radius));
    }
    block.sum.fill({});
}

TEST(Kernels, EveryInstructionSetStaysWithinTheBound)
{
    for (const Lanes& lanes : lanesHere())
        for (std::size_t m = 0; m < catalogue().size(); ++m) {
            const Model& model = catalogue()[m];
            const auto cases = batchOf(model.id(), blockSize);
            ShadeBlock<float> block;
            load(cases, block);
            lanes.kernels[m].shade(flatValues(model.text, cases[0].parameters).data(), block.batch(blockSize));
            for (std::size_t i = 0; i < blockSize; ++i)
                ASSERT_LE(ratioToBound(cases[i], Vec3d(block.sum[i]), false), 1.0) << lanes.name << ' ' << model.id();
        }
}

/// Values that differ between a batch of 64 and batches of 1 to 17 of the same rows, and writes past the end.
std::size_t differencesInTails(const Kernel<float>& kernel, const Model& model)
{
    const auto cases = batchOf(model.id(), 64);
    const auto values = flatValues(model.text, cases[0].parameters);
    ShadeBlock<float> whole;
    load(cases, whole);
    kernel.shade(values.data(), whole.batch(64));
    std::size_t differences = 0;
    for (std::size_t count = 1; count <= 17; ++count) {
        ShadeBlock<float> part;
        load(cases, part);
        kernel.shade(values.data(), part.batch(count));
        for (std::size_t i = 0; i < blockSize; ++i)
            differences += part.sum[i] != (i < count ? whole.sum[i] : Vec3f()) ? 1U : 0U;
    }
    return differences;
}

TEST(Kernels, TailsEqualWholeBatchesBitForBit)
{
    for (const Lanes& lanes : lanesHere())
        for (std::size_t m = 0; m < catalogue().size(); ++m)
            EXPECT_EQ(differencesInTails(lanes.kernels[m], catalogue()[m]), 0U) << lanes.name;
}

std::array<Vec3d, blockSize> inDouble(const KernelTable<double>& table, std::size_t model)
{
    const auto cases = batchOf(catalogue()[model].id(), blockSize);
    ShadeBlock<double> block;
    load(cases, block);
    table.models[model].shade(flatValues(catalogue()[model].text, cases[0].parameters).data(), block.batch(blockSize));
    std::array<Vec3d, blockSize> sums;
    for (std::size_t i = 0; i < blockSize; ++i)
        sums[i] = block.sum[i];
    return sums;
}

/// The truth does not depend on the processor.
TEST(Kernels, DoubleIsTheSameBitForBitOnEveryInstructionSet)
{
    if (std::strcmp(lanesName(), "avx2") == 0)
        for (std::size_t m = 0; m < catalogue().size(); ++m) {
            const auto narrow = inDouble(doubleKernelsSse2(), m);
            const auto wide = inDouble(doubleKernelsAvx2(), m);
            EXPECT_EQ(std::memcmp(narrow.data(), wide.data(), sizeof narrow), 0) << catalogue()[m].id();
        }
}

/// The planted fault: a kernel that forgets what does not fill a register, and one that writes whole registers.
TEST(Kernels, TheTailTestCatchesForgottenAndOverrunTails)
{
    const auto forgets = [](const double* values, const ShadeBatch<float>& batch) {
        ShadeBatch<float> whole = batch;
        whole.count = batch.count / 4 * 4;
        floatKernels().models[0].shade(values, whole);
    };
    const auto overruns = [](const double* values, const ShadeBatch<float>& batch) {
        ShadeBatch<float> whole = batch;
        whole.count = (batch.count + 3) / 4 * 4;
        floatKernels().models[0].shade(values, whole);
    };
    EXPECT_EQ(differencesInTails({floatKernels().models[0].shade, nullptr}, catalogue()[0]), 0U);
    EXPECT_GT(differencesInTails({+forgets, nullptr}, catalogue()[0]), 0U);
    EXPECT_GT(differencesInTails({+overruns, nullptr}, catalogue()[0]), 0U);
}

/// A light that tells where it comes from: red grows along x, green along y, blue along z.
template <class T> Vec3<T> colorOfDirection(const void* scale, const Vec3<T>& direction)
{
    return (direction + Vec3<T>(T(1))) * static_cast<T>(*static_cast<const double*>(scale));
}

TEST(Kernels, SurroundingsAreSeenAlongTheMirroredView)
{
    const double scale = 0.5;
    const std::vector<double> reflectance{0.75};
    const auto index = static_cast<std::size_t>(*findModel("mirror") - catalogue().data());
    const auto cases = randomCases("mirror", 53);
    ShadeBlock<double> truth;
    load(cases, truth);
    doubleKernels().models[index].environment(reflectance.data(),
                                              truth.environmentBatch(53, {colorOfDirection<double>, &scale}));
    std::vector<Lanes> all = lanesHere();
    all.push_back({"float", floatKernels().models});
    for (const Lanes& kernels : all) {
        ShadeBlock<float> block;
        load(cases, block);
        kernels.kernels[index].environment(reflectance.data(),
                                           block.environmentBatch(53, {colorOfDirection<float>, &scale}));
        for (std::size_t i = 0; i < 53; ++i) {
            const Vec3d N = normalized(cases[i].N);
            const Vec3d V = normalized(cases[i].V);
            const Vec3d expected = 0.375 * (2.0 * dot(N, V) * N - V + Vec3d(1, 1, 1));
            // R is rounded a few times; the light moves as much as R.
            ASSERT_LE(largestOf(truth.sum[i] - expected), 8.0 * 0x1p-53);
            ASSERT_LE(largestOf(Vec3d(block.sum[i]) - expected), 8.0 * 0x1p-24) << kernels.name;
        }
    }
}

TEST(Kernels, OnlyTheMirrorLooksAround)
{
    for (const Model& model : catalogue()) {
        EXPECT_EQ(model.exact.environment != nullptr, model.text.usesEnvironment) << model.id();
        EXPECT_EQ(model.lanes.environment != nullptr, model.text.usesEnvironment) << model.id();
    }
}

} // namespace
} // namespace reflectance::test
