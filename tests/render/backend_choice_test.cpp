// The backend that is sooner done: read from what was measured, measured once where nothing is known, and never from another's.
#include "core/render/pictures/backend_choice.h"

#include "core/base/file.h"
#include "tests/render/gl_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr RenderSettings small{24, 16, 1};

TEST(BackendChoice, IsTheCpuUnlessGlIsSoonerByAQuarter)
{
    EXPECT_EQ(soonerOf({100.0, 79.0}).backend, Backend::Cpu);
    EXPECT_EQ(soonerOf({100.0, 130.0}).backend, Backend::Cpu) << "as good as equal";
    EXPECT_EQ(soonerOf({100.0, 140.0}).backend, Backend::Auto);
    EXPECT_EQ(soonerOf({100.0, 300.0}).backend, Backend::Auto);
    EXPECT_THAT(soonerOf({100.0, 79.0}).why, HasSubstr("GL 100 ms, CPU 79 ms"));
}

TEST(BackendChoice, TellsSizesApartInStepsOfFour)
{
    EXPECT_EQ(sizeClass(1000, small, 1), sizeClass(1001, small, 1));
    EXPECT_NE(sizeClass(1000, small, 1), sizeClass(10000, small, 1));
    EXPECT_NE(sizeClass(1000, small, 1), sizeClass(1000, {24, 16, 3}, 1));
    EXPECT_NE(sizeClass(1000, small, 1), sizeClass(1000, small, 5));
    EXPECT_EQ(sizeClass(1000, small, 2), sizeClass(1000, small, 5));
}

TEST(BackendChoice, ReadsBackWhatWasWrittenAndNothingElse)
{
    const std::string one = sizeClass(1000, small, 1);
    const std::string many = sizeClass(1000, small, 9);
    std::string file = withTimes("", one, {12.5, 3.25});
    file = withTimes(file, many, {1.5, 30.0});
    ASSERT_TRUE(timesIn(file, one) && timesIn(file, many));
    EXPECT_EQ(timesIn(file, one)->gl, 12.5);
    EXPECT_EQ(timesIn(file, one)->cpu, 3.25);
    EXPECT_EQ(timesIn(file, many)->cpu, 30.0);
    EXPECT_FALSE(timesIn(file, sizeClass(5, small, 1)));
    EXPECT_FALSE(timesIn("", one));
    EXPECT_FALSE(timesIn("of another program" + file, one));
    const std::string start = file.substr(0, file.find('\n') + 1);
    for (const char* times : {"", " ", " 1", " 1 2 3", " a 2", " -1 2", " 0 2", " nan 2"})
        EXPECT_FALSE(timesIn(start + one + times + "\n", one)) << times;
    EXPECT_EQ(timesIn(withTimes("foreign\n", one, {1.0, 2.0}), one)->cpu, 2.0); // what was there is void
}

TEST(BackendChoice, KnowsAFileThatAlwaysTakesTheCpu)
{
    const std::string once = withTimes("", sizeClass(1000, small, 1), {12.5, 3.25});
    EXPECT_TRUE(isAlwaysTheCpu(once));
    EXPECT_TRUE(isAlwaysTheCpu(withTimes(once, sizeClass(100000, small, 1), {125.0, 32.5})));
    EXPECT_FALSE(isAlwaysTheCpu(withTimes(once, sizeClass(1000, small, 9), {1.5, 30.0})));
    EXPECT_FALSE(isAlwaysTheCpu(""));
    EXPECT_FALSE(isAlwaysTheCpu("of another program" + once));
    EXPECT_FALSE(isAlwaysTheCpu(once.substr(0, once.find('\n') + 1))) << "nothing is known yet";
}

class BackendFile : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(folder); }
    void TearDown() override { fs::remove_all(folder); }

    const fs::path folder =
        fs::path(testing::TempDir()) / // tests run side by side
        (std::string("backend_choice.") + testing::UnitTest::GetInstance()->current_test_info()->name());
    const Scene scene = twoLightScene("hybrid");
    const std::string ownClass = sizeClass(scene.mesh->triangles.size(), small, 1);
};

TEST_F(BackendFile, DecidesWithoutRendering)
{
    fs::create_directories(folder);
    for (const BackendTimes times : {BackendTimes{50.0, 5.0}, BackendTimes{5.0, 50.0}}) {
        const std::string content = withTimes("", ownClass, times);
        ASSERT_TRUE(writeAtomically((folder / "file").string(), content));
        const BackendChoice choice = soonerBackend(scene, small, {}, folder / "file");
        EXPECT_EQ(choice.backend, times.cpu < times.gl ? Backend::Cpu : Backend::Auto);
        EXPECT_EQ(*readWholeFile((folder / "file").string()), content);
    }
}

/// The tests' contexts are software: both are measured, once.
TEST_F(BackendFile, IsMadeByMeasuringBothOnce)
{
    const fs::path file = folder / "below" / "file";
    const BackendChoice first = soonerBackend(scene, small, {}, file);
    EXPECT_THAT(first.why, HasSubstr("measured here once: GL "));
    const std::string content = *readWholeFile(file.string());
    ASSERT_TRUE(timesIn(content, ownClass));
    const BackendChoice second = soonerBackend(scene, small, {}, file);
    EXPECT_EQ(second.backend, first.backend);
    EXPECT_EQ(*readWholeFile(file.string()), content);
}

TEST_F(BackendFile, ThatCannotBeWrittenMeansNoMeasurement)
{
    fs::create_directories(folder);
    ASSERT_TRUE(writeAtomically((folder / "file").string(), "no folder"));
    const BackendChoice choice = soonerBackend(scene, small, {}, folder / "file" / "below");
    EXPECT_EQ(choice.backend, Backend::Auto);
    EXPECT_THAT(choice.why, HasSubstr("could not be kept"));
    EXPECT_EQ(soonerBackend(scene, small, {}, {}).why, "");
}

} // namespace
} // namespace reflectance::test
