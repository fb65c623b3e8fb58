// Models of the user's own in the window: read by their ending, renewed when saved, the last good one kept.
#include "app/explorer/own_models.h"

#include "app/explorer/file_loader.h"
#include "tests/app/scratch_folder.h"

#include <fstream>
#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

using Time = OwnModelWatch::Time;
using std::chrono::seconds;

std::string textReturning(const std::string& value)
{
    return "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return " + value + "; }\n";
}

/// Writes the file as an editor would some seconds later; the file system's clock need not move between two tests.
void save(const std::string& path, const std::string& text, int later)
{
    std::ofstream(path) << text;
    std::filesystem::last_write_time(path, std::filesystem::file_time_type(seconds(1000 + later)));
}

TEST(OwnModels, AreReadByTheirEnding)
{
    const ScratchFolder scratch;
    const std::string path = (scratch.path / "mine.glsl").string();
    save(path, textReturning("I"), 0);
    FileLoader loader([] {});
    loader.start(path, false);
    loader.waitFor(std::chrono::minutes(1)); // returns as soon as it is there
    const auto file = loader.take();
    ASSERT_TRUE(file && file->content);
    EXPECT_EQ(std::get<std::shared_ptr<const Model>>(*file->content)->id(), "mine");
}

TEST(OwnModels, AreReadAgainOnceForEachSave)
{
    const ScratchFolder scratch;
    const std::string path = (scratch.path / "mine.glsl").string();
    save(path, textReturning("I"), 0);
    OwnModelWatch watch;
    EXPECT_FALSE(watch.saved(Time(seconds(1))));
    watch.watch(path);
    EXPECT_FALSE(watch.saved(Time(seconds(10))));
    save(path, textReturning("2.0 * I"), 5);
    const auto again = watch.saved(Time(seconds(20)));
    ASSERT_TRUE(again && *again);
    EXPECT_FALSE(watch.saved(Time(seconds(30))));
    save(path, textReturning("2.0 * J"), 7);
    const auto wrong = watch.saved(Time(seconds(40)));
    ASSERT_TRUE(wrong && !*wrong);
    EXPECT_EQ(wrong->error().line, 1);
    EXPECT_EQ(wrong->error().file, path);
    std::filesystem::remove(path); // between two versions of an editor that replaces the file
    EXPECT_FALSE(watch.saved(Time(seconds(50))));
}

TEST(OwnModels, AreRenewedWhereTheyAreInUse)
{
    const ScratchFolder scratch;
    const std::string path = (scratch.path / "mine.glsl").string();
    save(path, textReturning("I"), 0);
    Scene scene = defaultScene();
    ASSERT_TRUE(readModelOf(scene.surface, path));
    scene.other = scene.surface;
    scene.other->model = "phong"; // it keeps the own model in its menu
    save(path, textReturning("0.5 * I"), 5);
    Surface fresh;
    ASSERT_TRUE(readModelOf(fresh, path));
    EXPECT_TRUE(renewIn(scene, fresh.own, path));
    EXPECT_EQ(&modelOf(scene), fresh.own.get());
    EXPECT_EQ(modelOf(*scene.other).id(), "phong");
    EXPECT_EQ(scene.other->own, fresh.own);
    EXPECT_FALSE(renewIn(scene, fresh.own, "other.glsl"));
}

} // namespace
} // namespace reflectance::explorer
