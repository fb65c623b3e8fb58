// Sweeps: their figures against renders of our own, their file against kills, damage and other studies.
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/image/compare.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/scene_file.h"
#include "core/study/sweep/sweep.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

Study studyOf(const std::string& axes)
{
    const auto study = parseStudy(
        R"({"scene": {"mesh": "sphere", "camera": {"eye": [0, 0, 3.4]}}, "width": 24, "height": 24, "axes": [)" + axes +
            "]}",
        "study.json", "");
    EXPECT_TRUE(study) << study.error().sentence();
    return study ? *study : Study();
}

const std::string threeByTwo =
    R"({"axis": "n", "values": [4, 40, 400]}, {"axis": "renderer", "values": ["double", "float"]})";

class Sweeps : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() /
                  ("sweep_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                   std::to_string(::getpid())); // the same test may run in two trees at once
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        options_.out = (folder_ / "out.csv").string();
        options_.workers = 2;
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string text() const { return *readWholeFile(options_.out); }
    void put(const std::string& bytes) const { std::ofstream(options_.out, std::ios::binary) << bytes; }

    [[nodiscard]] std::vector<std::vector<std::string>> rows() const
    {
        std::vector<std::vector<std::string>> found;
        const std::string all = text();
        for (const std::string_view line : split(all, '\n'))
            if (!line.empty()) {
                found.emplace_back();
                for (const std::string_view cell : split(line, ','))
                    found.back().emplace_back(cell);
            }
        return found;
    }

    [[nodiscard]] std::string at(std::size_t cell, const std::string& column) const
    {
        const auto all = rows();
        for (std::size_t i = 0; i < all[0].size(); ++i)
            if (all[0][i] == column)
                return all[cell + 1][i];
        return "no such column";
    }

    fs::path folder_;
    SweepOptions options_;
};

TEST_F(Sweeps, FiguresAreThoseOfTheRender)
{
    const Study study = studyOf(threeByTwo);
    const auto done = sweep(study, options_);
    ASSERT_TRUE(done) << done.error().sentence();
    EXPECT_EQ(done->cells, 6U);
    EXPECT_EQ(done->failed, 0U);
    const auto scene = parseScene(cellAt(study, 3).scene, "", "");
    const Image truth = renderOnCpu(*scene, study.settings, Precision::Double);
    const Image image = renderOnCpu(*scene, study.settings, Precision::Float);
    const auto expected = compared(truth, image);
    EXPECT_EQ(at(3, "n"), "40");
    EXPECT_EQ(at(3, "renderer"), "float");
    // The same functions on the same values: equal, whether in bands or at once.
    EXPECT_EQ(at(3, "rmse"), shortest(expected->rmse));
    EXPECT_EQ(at(3, "max_abs"), shortest(expected->maxAbs));
    EXPECT_GT(expected->maxAbs, 0.0) << "or this test compares nothing";
    EXPECT_EQ(at(2, "rmse"), "0") << "double is the truth itself";
}

/// White Lambert that faces its light is 1 all over a plane of the picture: mean, largest and coverage in closed form.
TEST_F(Sweeps, ALitDiscHasItsClosedForm)
{
    const auto study =
        parseStudy(R"({"scene": {"mesh": "sphere", "camera": {"eye": [0, 0, 3.4]}, "environment": {"kind": "none"},
        "surface": {"model": "lambert"}, "lights": [{"direction": [0, 0, 1], "intensity": [1, 1, 1]}]},
        "width": 64, "height": 64, "axes": [{"axis": "kd", "values": [0.5, 1]}]})",
                   "study.json", "");
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_TRUE(sweep(*study, options_));
    const double half = *parseNumber(at(0, "mean")), whole = *parseNumber(at(1, "mean"));
    EXPECT_NEAR(whole / half, 2.0, 1e-6) << "float pictures: 24 bits, averaged";
    const double largest = *parseNumber(at(1, "max"));
    EXPECT_LE(largest, 1.0 + 1e-6);
    EXPECT_GT(largest, 0.99) << "the middle pixel faces the light";
    // Seen from 3.4 the unit sphere's outline has half the angle asin(1/3.4); the picture spans 35 degrees.
    const double radius = std::tan(std::asin(1.0 / 3.4)) / std::tan(17.5 * 3.14159265358979 / 180.0) / 2.0;
    EXPECT_NEAR(*parseNumber(at(0, "covered")), 3.14159265358979 * radius * radius, 0.02)
        << "pixels and facets at the rim";
}

TEST_F(Sweeps, BytesDoNotDependOnTheWorkers)
{
    const Study study = studyOf(threeByTwo);
    ASSERT_TRUE(sweep(study, options_));
    const std::string first = text();
    for (const unsigned workers : {1U, 5U}) {
        fs::remove(options_.out);
        options_.workers = workers;
        ASSERT_TRUE(sweep(study, options_));
        EXPECT_EQ(text(), first) << workers;
    }
}

/// Whatever byte a kill left it at, the next run gives the file of an unbroken one.
TEST_F(Sweeps, GoesOnFromAnyByte)
{
    const Study study = studyOf(threeByTwo);
    ASSERT_TRUE(sweep(study, options_));
    const std::string whole = text();
    for (std::size_t length = 0; length <= whole.size(); length += length < 8 ? 1 : 61) {
        put(whole.substr(0, length));
        const auto done = sweep(study, options_);
        ASSERT_TRUE(done) << length << ": " << done.error().sentence();
        EXPECT_EQ(text(), whole) << length;
    }
    const auto again = sweep(study, options_);
    EXPECT_EQ(again->before, 6U) << "nothing is computed twice";
}

TEST_F(Sweeps, CancelKeepsWhatIsDone)
{
    const Study study = studyOf(threeByTwo);
    Progress progress;
    progress.cancel = true;
    const auto stopped = sweep(study, options_, &progress);
    ASSERT_FALSE(stopped);
    EXPECT_NE(stopped.error().message.find("stopped after 0 of 6 cells"), std::string::npos);
    ASSERT_TRUE(sweep(study, options_));
    EXPECT_EQ(rows().size(), 7U);
}

TEST_F(Sweeps, AFailureStaysInItsCell)
{
    const Study study =
        studyOf(R"({"axis": "n", "values": [4, -1, 40]}, {"axis": "mesh", "values": ["sphere", "nowhere.obj"]})");
    const auto done = sweep(study, options_);
    ASSERT_TRUE(done) << done.error().sentence();
    EXPECT_EQ(done->failed, 4U);
    EXPECT_EQ(at(0, "error"), "");
    EXPECT_NE(text().find("nowhere.obj: there is no such file"), std::string::npos);
    EXPECT_NE(text().find("n = -1 "), std::string::npos);
    EXPECT_EQ(rows().size(), 7U);
    EXPECT_EQ(sweep(study, options_)->failed, 4U) << "failures are counted when they are read back, too";
}

/// The system kills a process that writes a larger file than it may: a picture of 256 x 256, not one of 16 x 16, nor the figures.
TEST_F(Sweeps, ACrashStaysInItsCell)
{
    const Study study = studyOf(R"({"axis": "size", "values": [[16, 16], [256, 256], [17, 17], [18, 18]]})");
    options_.pictures = (folder_ / "pictures").string();
    const rlimit before = [] {
        rlimit now{};
        ::getrlimit(RLIMIT_FSIZE, &now);
        return now;
    }();
    const rlimit small{8192, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto done = sweep(study, options_);
    ::setrlimit(RLIMIT_FSIZE, &before);
    ASSERT_TRUE(done) << done.error().sentence();
    EXPECT_EQ(done->failed, 1U);
    EXPECT_EQ(at(0, "error"), "");
    EXPECT_EQ(at(1, "error"), "its process crashed: File size limit exceeded");
    EXPECT_EQ(at(2, "error"), "");
    EXPECT_EQ(at(3, "error"), "");
}

TEST_F(Sweeps, OthersFilesAreLeftAlone)
{
    const Study study = studyOf(threeByTwo);
    for (const char* foreign : {"a,b\n1,2\n", "my notes", "cell,n\n"}) {
        put(foreign);
        const auto refused = sweep(study, options_);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().message.find("another study"), std::string::npos);
        EXPECT_EQ(text(), foreign);
    }
    // The planted fault: one digit of one input. Figures of two studies must never share a file.
    fs::remove(options_.out);
    ASSERT_TRUE(sweep(study, options_));
    const std::string before = text();
    const Study other =
        studyOf(R"({"axis": "n", "values": [4, 41, 400]}, {"axis": "renderer", "values": ["double", "float"]})");
    EXPECT_FALSE(sweep(other, options_));
    EXPECT_EQ(text(), before);
}

TEST_F(Sweeps, PicturesAreWritten)
{
    options_.pictures = (folder_ / "a" / "b").string();
    ASSERT_TRUE(sweep(studyOf(threeByTwo), options_));
    for (int i = 0; i < 6; ++i)
        EXPECT_TRUE(fs::exists(options_.pictures + "/cell_" + std::to_string(i) + ".png"));
}

TEST_F(Sweeps, BadPlacesAreRefused)
{
    const Study study = studyOf(threeByTwo);
    options_.pictures = options_.out; // a file
    put("");
    EXPECT_FALSE(sweep(study, options_));
    options_.pictures = "";
    options_.out = (folder_ / "missing" / "out.csv").string();
    EXPECT_FALSE(sweep(study, options_));
    options_.out = folder_.string();
    EXPECT_FALSE(sweep(study, options_));
}

TEST_F(Sweeps, TimingIsAColumnOfItsOwn)
{
    options_.timing = true;
    ASSERT_TRUE(sweep(studyOf(threeByTwo), options_));
    EXPECT_GE(*parseNumber(at(0, "ms")), 0.0);
    options_.timing = false;
    EXPECT_FALSE(sweep(studyOf(threeByTwo), options_)) << "the columns are others";
}

TEST_F(Sweeps, GlAndVerticesAreHeldAgainstDoubleOnTheirSamples)
{
    ASSERT_TRUE(sweep(studyOf(R"({"axis": "renderer", "values": ["glsl", "vertex"]})"), options_));
    EXPECT_EQ(at(0, "error"), "");
    EXPECT_LT(*parseNumber(at(0, "max_abs")), 1e-4) << "float arithmetic, no difference of outlines";
    EXPECT_GT(*parseNumber(at(1, "max_abs")), 1e-3) << "a highlight between vertices is lost";
}

TEST_F(Sweeps, AnEstimateGrowsWithTheStudy)
{
    const SweepEstimate small = estimated(studyOf(threeByTwo), options_);
    const SweepEstimate large = estimated(
        studyOf(
            R"({"axis": "n", "from": 1, "to": 9, "steps": 100000}, {"axis": "ks", "from": 0, "to": 1, "steps": 10000})"),
        options_);
    EXPECT_GT(small.bytes, 6.0 * 60.0);
    EXPECT_GT(large.bytes, 1e9 * 60.0) << "a line is longer than 60 bytes";
    EXPECT_GT(large.seconds, 0.0);
}

} // namespace
} // namespace reflectance
