// Files that are no files, names, progress and giving up.
#include "tests/geometry/mesh_text.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace reflectance::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder of its own, removed at the end of each test.
class LoadTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        std::string pattern = (fs::temp_directory_path() / "reflectance-load-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string file(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return (folder_ / name).string();
    }
    std::string sentence(const std::string& path) const
    {
        const auto mesh = loadMesh(path);
        return mesh ? std::string() : mesh.error().sentence();
    }

    fs::path folder_;
};

TEST_F(LoadTest, ReadsAFileAndNamesTheMesh)
{
    const auto mesh = loadMesh(file("my cube.obj", cubeVertices() + cubeFaces()));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh.value().mesh->name, "my cube");
    EXPECT_EQ(mesh.value().report.area, 24.0);
}

TEST_F(LoadTest, TheContentsDecideNotTheExtension)
{
    const auto mesh = loadMesh(file("cube.stl", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh.value().report.format, "OFF");
}

TEST_F(LoadTest, WhatIsNoFileIsRefused)
{
    EXPECT_THAT(sentence(folder_.string()), HasSubstr("folder"));
    const std::string pipe = (folder_ / "pipe.obj").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(sentence(pipe), HasSubstr("pipe"));
    fs::create_symlink("/dev/zero", folder_ / "endless.stl");
    EXPECT_THAT(sentence((folder_ / "endless.stl").string()), HasSubstr("device"));
    EXPECT_THAT(sentence((folder_ / "nothing.obj").string()), HasSubstr("nothing.obj: there is no such file"));
    EXPECT_EQ(sentence(file("good.obj", cubeVertices() + cubeFaces())), "") << "and a file is not";
}

/// Whoever may do everything reads as nobody, who may not.
class AsNobody {
public:
    AsNobody() : user_(::geteuid()) { isNobody_ = user_ != 0 || ::seteuid(nobody) == 0; }
    ~AsNobody() { EXPECT_EQ(::seteuid(user_), 0); }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;
    [[nodiscard]] bool isNobody() const { return isNobody_; }

private:
    static constexpr uid_t nobody = 65534;
    uid_t user_;
    bool isNobody_;
};

TEST_F(LoadTest, AFileWithoutPermissionIsRefused)
{
    const std::string secret = file("secret.obj", cubeVertices() + cubeFaces());
    const std::string open = file("open.obj", cubeVertices() + cubeFaces());
    fs::permissions(folder_, fs::perms(0755));
    fs::permissions(secret, fs::perms::none);
    const AsNobody reader;
    ASSERT_TRUE(reader.isNobody());
    EXPECT_THAT(sentence(secret), HasSubstr("secret.obj: cannot be opened for reading; check its permissions"));
    EXPECT_EQ(sentence(open), "") << "and an open file is read";
}

/// 2 GB that take no place on the disk: the first bytes tell, so that memory and time are not spent on the rest.
TEST_F(LoadTest, TwoGigabytesOfNothingAreRefusedAtOnce)
{
    const std::string path = file("nothing.obj", "");
    fs::resize_file(path, std::uintmax_t{2} << 30U);
    EXPECT_THAT(sentence(path), HasSubstr("nothing.obj: is not a mesh of a known format"));
}

/// One writer cuts the file and writes it anew while it is read again and again: each reading gets a whole cube or a
/// sentence.
TEST_F(LoadTest, AFileThatShrinksWhileItIsReadIsAMeshOrASentence)
{
    const std::string whole = std::string(1'000'000, '#') + "\n" + cubeVertices() + cubeFaces();
    const std::string path = file("restless.obj", whole);
    std::atomic<bool> stop = false;
    std::thread writer([&] {
        while (!stop) {
            fs::resize_file(path, 10);
            std::ofstream(path, std::ios::binary) << whole;
        }
    });
    for (int i = 0; i < 100; ++i) {
        const auto mesh = loadMesh(path);
        if (mesh)
            EXPECT_EQ(mesh.value().report.fileVertices, 8U);
        else
            EXPECT_GT(mesh.error().message.size(), 10U);
    }
    stop = true;
    writer.join();
    EXPECT_EQ(sentence(path), "") << "at rest it is read";
}

TEST_F(LoadTest, AMaterialFileIsNeverOpened)
{
    // A pipe would block whoever opened it.
    ASSERT_EQ(::mkfifo((folder_ / "trap.mtl").c_str(), 0600), 0);
    EXPECT_EQ(sentence(file("cube.obj", "mtllib trap.mtl\nmtllib ../../../dev/zero\n" + cubeVertices() + cubeFaces())),
              "");
}

TEST(Load, UnknownNamesGetAnAnswerThatHelps)
{
    const auto mesh = loadStockOrFile("mugg");
    ASSERT_FALSE(mesh);
    EXPECT_THAT(mesh.error().sentence(), HasSubstr("mug, sphere"));
}

TEST(Load, ShowsProgressAndCanBeStopped)
{
    const std::string text = sphereObj(300, 300);
    std::atomic<double> progress = -1.0;
    std::atomic<bool> cancel = false;
    LoadOptions options;
    options.progress = &progress;
    options.cancel = &cancel;
    ASSERT_TRUE(readMesh(text, "a.obj", options));
    EXPECT_EQ(progress, 1.0);
    cancel = true;
    const auto stopped = readMesh(text, "a.obj", options);
    ASSERT_FALSE(stopped);
    EXPECT_THAT(stopped.error().message, HasSubstr("stopped"));
}

} // namespace
} // namespace reflectance::testing
