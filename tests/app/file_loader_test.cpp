// Files are read beside the window: results arrive once, cancelled ones never.
#include "app/explorer/file_loader.h"
#include "core/measured/write.h"
#include "core/scene/scene_file.h"
#include "tests/app/scratch_folder.h"

#include <gmock/gmock.h>

#include <atomic>
#include <fstream>

namespace reflectance::explorer {
namespace {

// Long enough for any machine; waitFor returns as soon as the file is there.
constexpr std::chrono::milliseconds patience(60000);

std::optional<LoadedFile> loaded(const std::string& path)
{
    FileLoader loader([] {});
    loader.start(path, false);
    loader.waitFor(patience);
    return loader.take();
}

TEST(FileLoader, ReadsMeshesAndScenesByTheirEnding)
{
    const ScratchFolder scratch;
    const std::string mesh = (scratch.path / "triangle.obj").string();
    std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::optional<LoadedFile> file = loaded(mesh);
    ASSERT_TRUE(file && file->content) << (file ? file->content.error().sentence() : "nothing");
    EXPECT_EQ(file->path, mesh);
    EXPECT_EQ(std::get<std::shared_ptr<const Mesh>>(*file->content)->triangles.size(), 1U);

    Scene scene = defaultScene();
    scene.sensor.exposure = 1.25;
    const std::string path = (scratch.path / "scene.json").string();
    ASSERT_TRUE(saveScene(scene, path));
    const std::optional<LoadedFile> again = loaded(path);
    ASSERT_TRUE(again && again->content);
    EXPECT_EQ(std::get<Scene>(*again->content).sensor.exposure, 1.25);

    const std::optional<LoadedFile> stock = loaded("sphere");
    ASSERT_TRUE(stock && stock->content);
    EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const Mesh>>(*stock->content));
}

TEST(FileLoader, ReadsMeasurementsFromCsvAndFromJsonThatIsNoScene)
{
    const ScratchFolder scratch;
    Table table;
    table.axes = {{0.0, 1.0}, {0.0, 1.0}};
    table.values = {0.1, 0.2, 0.3, 0.4};
    for (const TableFormat format : {TableFormat::Csv, TableFormat::OpenMaterial}) {
        const std::string path = (scratch.path / (format == TableFormat::Csv ? "paper.csv" : "paper.json")).string();
        std::ofstream(path) << bytesOf(format, table);
        const std::optional<LoadedFile> file = loaded(path);
        ASSERT_TRUE(file && file->content) << (file ? file->content.error().sentence() : "nothing");
        EXPECT_EQ(std::get<std::shared_ptr<const MeasuredTable>>(*file->content)->table.samples(), 4U);
    }
}

TEST(FileLoader, SaysWhatIsWrongWithAFile)
{
    const ScratchFolder scratch;
    for (const char* name : {"broken.obj", "broken.json", "broken.exr", "broken.hdr", "broken.csv", "broken.binary"}) {
        const std::string path = (scratch.path / name).string();
        std::ofstream(path) << "nothing of any use\n";
        const std::optional<LoadedFile> file = loaded(path);
        ASSERT_TRUE(file) << name;
        ASSERT_FALSE(file->content) << name;
        EXPECT_THAT(file->content.error().sentence(), testing::HasSubstr(name));
    }
    EXPECT_FALSE(loaded((scratch.path / "absent.obj").string())->content);
}

TEST(FileLoader, WakesAndHandsOverOnce)
{
    std::atomic<int> wakes{0};
    FileLoader loader([&wakes] {
        ++wakes;
        wakes.notify_all();
    });
    EXPECT_FALSE(loader.take());
    EXPECT_FALSE(loader.progress());
    loader.start("sphere", false);
    ASSERT_TRUE(loader.progress());
    EXPECT_EQ(loader.progress()->file, "sphere");
    wakes.wait(0);
    EXPECT_TRUE(loader.take());
    EXPECT_FALSE(loader.take());
    EXPECT_FALSE(loader.progress());
}

TEST(FileLoader, CancelledAndReplacedFilesNeverArrive)
{
    FileLoader loader([] {});
    loader.start("mug", false);
    loader.cancel();
    EXPECT_FALSE(loader.progress());
    loader.waitFor(patience);
    EXPECT_FALSE(loader.take());
    for (int i = 0; i < 20; ++i)
        loader.start("mug", false);
    loader.start("sphere", false);
    loader.waitFor(patience);
    const std::optional<LoadedFile> last = loader.take();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->path, "sphere");
    EXPECT_FALSE(loader.take());
}

} // namespace
} // namespace reflectance::explorer
