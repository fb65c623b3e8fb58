// A fixed number of damaged files for every reader, the same every time: nothing crashes, nothing throws, and every
// promise of promises.h is kept. The fuzz preset goes on where this stops.
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/readers.h"

#include <gtest/gtest.h>
#include <iostream>
#include <ostream>

namespace reflectance::fuzz {

static void PrintTo(const Reader& reader, std::ostream* out)
{
    *out << reader.name;
}

namespace {

/// A scene reads the mug again, a damaged header of a picture may ask for megabytes: they get fewer.
std::size_t inputsFor(const Reader& reader)
{
    if (reader.name == "scene" || reader.name == "session" || reader.name == "kept")
        return 1000;
    return reader.name == "png" || reader.name == "exr" ? 2000 : 20000;
}

struct Tally {
    std::size_t inputs = 0;
    std::size_t accepted = 0;
    std::string broken; ///< the first promise that was not kept
};

Tally fedWithDamage(const Reader& reader)
{
    std::mt19937_64 random(20240229);
    Tally tally;
    for (; tally.inputs < inputsFor(reader) && tally.broken.empty(); ++tally.inputs) {
        const auto& seeds = reader.seeds;
        const std::string& seed = seeds[tally.inputs % seeds.size()];
        const std::string& other = seeds[random() % seeds.size()];
        const Outcome outcome = reader.read(damaged(seed, other, random));
        tally.accepted += outcome.accepted ? 1 : 0;
        if (!outcome.broken.empty())
            tally.broken = "input " + std::to_string(tally.inputs) + ": " + outcome.broken;
    }
    return tally;
}

class EveryReader : public testing::TestWithParam<Reader> {};

TEST_P(EveryReader, AcceptsItsSeeds)
{
    for (const std::string& seed : GetParam().seeds) {
        const Outcome outcome = GetParam().read(seed);
        EXPECT_TRUE(outcome.accepted) << seed;
        EXPECT_EQ(outcome.broken, "") << seed;
    }
}

TEST_P(EveryReader, KeepsItsPromisesWhateverTheDamage)
{
    Tally tally;
    ASSERT_NO_THROW(tally = fedWithDamage(GetParam()));
    EXPECT_EQ(tally.broken, "");
    EXPECT_EQ(tally.inputs, inputsFor(GetParam()));
    // Damage that always or never goes through would test only half of the reader.
    EXPECT_GT(tally.accepted, 0U);
    EXPECT_LT(tally.accepted, tally.inputs);
    RecordProperty("inputs", std::to_string(tally.inputs));
    RecordProperty("accepted", std::to_string(tally.accepted));
    std::cout << GetParam().name << ": " << tally.inputs << " inputs, " << tally.accepted << " accepted\n";
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryReader, testing::ValuesIn(readers()),
                         [](const auto& reader) { return std::string(reader.param.name); });

TEST(Mutations, AreTheSameEveryTimeAndDifferFromEachOther)
{
    const std::string file = "v 0 0 0\nv 1 0 0\nf 1 2 3\n";
    std::mt19937_64 first(1);
    std::mt19937_64 second(1);
    const std::string once = damaged(file, file, first);
    EXPECT_EQ(once, damaged(file, file, second));
    EXPECT_NE(once, damaged(file, file, first));
}

/// A reader with a hole: it believes the index -1.
TEST(Mutations, FindAPlantedHole)
{
    const auto believeAll = [](std::string_view text) {
        const bool isWrong = text.find(" -1") != std::string_view::npos;
        return Outcome{true, isWrong ? "an index before the first position" : ""};
    };
    const Reader hole{"hole", believeAll, {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};
    EXPECT_NE(fedWithDamage(hole).broken, "");
}

} // namespace
} // namespace reflectance::fuzz
