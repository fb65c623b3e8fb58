// Linked programs kept on disk: the same pictures, from the folder; whatever else lies there is put right.
#include "core/base/file.h"
#include "core/render/gl/program_linker.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/gl_scenes.h"

#include <fstream>

namespace reflectance::test {
namespace {

namespace fs = std::filesystem;

constexpr RenderSettings small{64, 48, 2};

class GlPrograms : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string(test.name()) + ".programs";
        std::replace(name.begin(), name.end(), '/', '-');
        folder_ = fs::path(testing::TempDir()) / name;
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    Image picture()
    {
        render(twoLightScene("hybrid"), small);
        return renderer().readLinear();
    }
    /// A new renderer, as after a new start; how many of its programs came from the folder.
    std::uint64_t loadedByANewStart()
    {
        startAnew(folder_);
        again_ = picture();
        return renderer().work().programsLoaded;
    }
    std::vector<fs::path> files() const
    {
        std::vector<fs::path> found;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            found.push_back(entry.path());
        return found;
    }

    fs::path folder_;
    Image again_;
};

TEST_P(GlPrograms, AreLoadedByTheNextStartAndDrawTheSame)
{
    EXPECT_EQ(loadedByANewStart(), 0U);
    const Image first = again_;
    const std::uint64_t linked = renderer().work().programLinks;
    EXPECT_EQ(files().size(), linked);
    EXPECT_EQ(loadedByANewStart(), linked);
    EXPECT_EQ(again_.rgb, first.rgb);
}

TEST_P(GlPrograms, NothingIsKeptWithoutAFolder)
{
    startAnew();
    picture();
    EXPECT_EQ(renderer().work().programsLoaded, 0U);
    EXPECT_FALSE(fs::exists(folder_));
}

/// One way of spoiling a kept file each; the program is linked anew and the file put right.
TEST_P(GlPrograms, SpoiledFilesAreReplaced)
{
    EXPECT_EQ(loadedByANewStart(), 0U);
    const std::uint64_t all = files().size();
    const auto spoil = [&](const std::function<std::string(std::string)>& change) {
        for (const fs::path& file : files()) {
            const std::string bytes = *readWholeFile(file.string());
            std::ofstream(file, std::ios::binary | std::ios::trunc) << change(bytes);
        }
    };
    const std::vector<std::function<std::string(std::string)>> changes{
        [](std::string) { return std::string(); },
        [](std::string bytes) { return bytes.substr(0, bytes.size() / 2); },
        [](std::string bytes) { return bytes.substr(0, bytes.size() - 1); },
        [](std::string bytes) {
            bytes.back() = static_cast<char>(bytes.back() ^ 1);
            return bytes;
        },
        [](std::string bytes) {
            bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x40);
            return bytes;
        },
        [](std::string) { return std::string("reflectance program 1\n99999999999999999999 1 1\n"); },
        [](std::string) { return std::string("reflectance program 1\n1 18446744073709551615 1\n"); },
        [](std::string) { return std::string(5000, '\xff'); },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        spoil(changes[i]);
        EXPECT_EQ(loadedByANewStart(), 0U) << "change " << i;
        EXPECT_EQ(loadedByANewStart(), all) << "after change " << i;
    }
}

/// Not to be written where a file stands in the folder's place: the picture comes all the same.
TEST_P(GlPrograms, AnUnusableFolderCostsNoPicture)
{
    std::ofstream(folder_) << "a file";
    EXPECT_EQ(loadedByANewStart(), 0U);
    EXPECT_GT(again_.rgb.size(), 0U);
    EXPECT_TRUE(fs::is_regular_file(folder_));
}

TEST_P(GlPrograms, TheOldestMakeRoom)
{
    fs::create_directories(folder_);
    for (std::size_t i = 0; i < ProgramLinker::largestNumberOfFiles; ++i)
        std::ofstream(folder_ / ("old" + std::to_string(i))) << "old";
    loadedByANewStart();
    EXPECT_EQ(files().size(), ProgramLinker::largestNumberOfFiles);
    const std::uint64_t loaded = loadedByANewStart();
    EXPECT_EQ(loaded, renderer().work().programLinks) << "the new ones stay";
}

IN_EVERY_CONTEXT(GlPrograms);

} // namespace
} // namespace reflectance::test
