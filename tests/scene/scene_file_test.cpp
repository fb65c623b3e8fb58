// Scene files: what is written is read back equal, and what is wrong is said in one sentence.
#include "core/scene/scene_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

Scene unusualScene()
{
    Scene scene = defaultScene();
    scene.recomputeNormals = true;
    scene.camera.eye = {0.1, 1.0 / 3.0, -4.0};
    scene.camera.fieldOfView = 61.7;
    Light point;
    point.name = "a \"quoted\" point";
    point.kind = LightKind::Point;
    point.position = {1e-3, 2.0, -1e7};
    point.intensity = {0.1, 0.0, 1e6};
    point.angularRadius = 0.25;
    point.on = false;
    scene.lights.push_back(point);
    scene.environment.kind = EnvironmentKind::Constant;
    scene.environment.rotation = -12.5;
    scene.background = {BackgroundKind::Environment, {0.5, 0.25, 0.125}};
    scene.surface.model = "phong";
    scene.surface.values["n"] = {1e7};
    scene.surface.values["K"] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, -0.9};
    scene.surface.convention = Convention::Primary;
    scene.surface.W = {0.837, 0.105, 0.058, 0.219, 0.513, 0.268, 0.06, 1.0 / 3.0, 0.774};
    scene.other = Surface{"oren_nayar", {{"sigma", {0.7}}}};
    scene.other->rungs = {"double", "eon"};
    scene.pins = {{"rim", scene.meshFile, {0.1, 1.0 / 3.0, -0.2}, 7}, {"2", "sphere", {0.0, 1.0, 0.0}, 123456}};
    scene.sensor.exposure = -3.3;
    scene.sensor.camera = {true, 2.8, 1.0 / 30.0, 400.0, 1000.0};
    scene.sensor.vignetting = {true, FallOff::Polynomial, 31.0, {-0.1, 0.2, -0.3}};
    scene.sensor.noise = {true, false, 1.0 / 3.0, 1e5, 77};
    scene.sensor.well.on = false;
    scene.sensor.balance = {true, {1.5, 1.0, 2.0}, {1, 2, 3, 4, 5, 6, 7, 8, 0.1}};
    scene.sensor.response.on = true;
    scene.sensor.encoding.kind = EncodingKind::Rec709;
    scene.sensor.quantisation = {true, 12, true};
    scene.sensor.view = {SensorViewKind::FalseColor, true};
    return scene;
}

bool equal(const Scene& a, const Scene& b)
{
    return a.meshFile == b.meshFile && a.recomputeNormals == b.recomputeNormals && a.camera == b.camera &&
           a.lights == b.lights && a.environment == b.environment && a.background == b.background &&
           a.surface == b.surface && a.other == b.other && a.sensor == b.sensor && a.pins == b.pins;
}

TEST(SceneFile, ReadsBackWhatItWroteBitForBit)
{
    Scene scene = unusualScene();
    // A directional light is written with its direction only, a point light with its position only.
    scene.lights.back().direction = Light().direction;
    const auto read = parseScene(sceneText(scene, ""), "scene.json", "");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(equal(*read, scene));
    EXPECT_EQ(read->mesh->triangles.size(), scene.mesh->triangles.size());
}

TEST(SceneFile, TakesASurfaceOfTheLibraryAndWhatStandsBesideItComesAfter)
{
    const auto read = parseScene(R"({"surface": {"library": "curet_oren_nayar/velvet", "parameters": {"rho": 0.5}}})",
                                 "scene.json", "");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->surface.model, "oren_nayar");
    EXPECT_EQ(read->surface.values.at("sigma"), std::vector<double>{1.4});
    EXPECT_EQ(read->surface.values.at("rho"), (std::vector<double>{0.5, 0.5, 0.5}));
    const auto unknown = parseScene(R"({"surface": {"library": "velvt"}})", "scene.json", "");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("'velvet'"), std::string::npos) << unknown.error().message;
}

TEST(SceneFile, NamesAMeshSoThatItIsFoundFromAnyFolder)
{
    Scene scene = defaultScene();
    scene.meshFile = "meshes/bunny.obj";
    const std::string here = std::filesystem::current_path().string();
    const auto holds = [&](const std::string& folder, const std::string& mesh) {
        return sceneText(scene, folder).find("\"mesh\": \"" + mesh + "\"") != std::string::npos;
    };
    EXPECT_TRUE(holds("", "meshes/bunny.obj"));
    EXPECT_TRUE(holds(here + "/meshes", "bunny.obj"));
    EXPECT_TRUE(holds("meshes", "bunny.obj"));
    EXPECT_TRUE(holds("scenes", here + "/meshes/bunny.obj"));
    EXPECT_TRUE(holds("/elsewhere", here + "/meshes/bunny.obj"));
    EXPECT_FALSE(holds("/elsewhere", "meshes/bunny.obj")); // planted: from there it would not be found
}

TEST(SceneFile, RefusesNamesThatJsonCannotHold)
{
    Scene scene = defaultScene();
    scene.meshFile = "/meshes/b\xff.obj";
    const auto saved = saveScene(scene, testing::TempDir() + "/scene.json");
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().sentence().find("not UTF-8"), std::string::npos);
    EXPECT_FALSE(sceneText(scene, "").empty());
    scene.meshFile = "/meshes/b\u00f6.obj";
    EXPECT_TRUE(saveScene(scene, testing::TempDir() + "/scene.json"));
}

TEST(SceneFile, ASmallDifferenceIsADifference) // the planted fault of this suite
{
    Scene scene = unusualScene();
    const auto read = parseScene(sceneText(scene, ""), "scene.json", "");
    ASSERT_TRUE(read);
    scene.sensor.exposure = std::nextafter(scene.sensor.exposure, 0.0);
    EXPECT_FALSE(equal(*read, scene));
}

/// A made measurement in a file of the scratch folder; its name.
std::string writtenTable(const char* name, const std::string& text)
{
    std::ofstream(testing::TempDir() + "/" + name) << text;
    return name;
}

constexpr const char* paper = "theta_i_deg,theta_r_deg,f\n0,0,0.1\n0,90,0.2\n90,0,0.3\n90,90,0.4\n";

TEST(SceneFile, FindsItsMeasurementFromItsOwnFolder)
{
    Scene scene = defaultScene();
    scene.surface.model = "table";
    const std::string file = testing::TempDir() + "/" + writtenTable("paper.csv", paper);
    ASSERT_TRUE(readTableOf(scene.surface, file));
    const std::string text = sceneText(scene, testing::TempDir());
    EXPECT_NE(text.find("\"file\": \"paper.csv\""), std::string::npos) << text;
    const auto read = parseScene(text, "scene.json", testing::TempDir());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->surface.table->table.values, scene.surface.table->table.values);
    EXPECT_EQ(read->surface.model, "table");
}

TEST(SceneFile, AMissingOrDamagedMeasurementIsOneSentenceAndTheLastOneStays)
{
    Scene scene = defaultScene();
    scene.surface.model = "table";
    ASSERT_TRUE(readTableOf(scene.surface, testing::TempDir() + "/" + writtenTable("paper.csv", paper)));
    const auto before = scene.surface;
    writtenTable("damaged.csv", "theta_i_deg,theta_r_deg,f\n0,0,0.1\n0,120,0.2\n");
    for (const char* name : {"damaged.csv", "missing.csv"}) {
        const auto read = parseScene(std::string(R"({"surface": {"model": "table", "file": ")") + name + "\"}}",
                                     "scene.json", testing::TempDir());
        ASSERT_FALSE(read) << name;
        EXPECT_NE(read.error().sentence().find(name), std::string::npos) << read.error().sentence();
        EXPECT_EQ(read.error().sentence().find('\n'), std::string::npos);
        EXPECT_FALSE(setOnSurface("file=" + testing::TempDir() + "/" + name, scene.surface));
        EXPECT_EQ(scene.surface.table, before.table);
        EXPECT_EQ(scene.surface.tableFile, before.tableFile);
    }
}

TEST(SceneFile, EmptyObjectIsTheDefaultScene)
{
    const auto read = parseScene("{}", "scene.json", "");
    ASSERT_TRUE(read);
    EXPECT_TRUE(equal(*read, defaultScene()));
}

struct BadScene {
    const char* text;
    const char* sentence;
};

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreSaidInOneSentence)
{
    const auto read = parseScene(GetParam().text, "scene.json", "");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().sentence().find(GetParam().sentence), std::string::npos) << read.error().sentence();
    EXPECT_EQ(read.error().sentence().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    SceneFile, BadScenes,
    testing::Values(BadScene{"", "scene.json:1: not a JSON scene"},
                    BadScene{"{\n\n]", "scene.json:3: not a JSON scene"}, BadScene{"[]", "scene is not an object"},
                    BadScene{R"({"ligths": []})", "did you mean 'lights'"},
                    BadScene{R"({"lights": {}})", "scene.lights is not a list"},
                    BadScene{R"({"lights": [{"kind": "spot"}]})", "scene.lights[0].kind is 'spot'; choose one of"},
                    BadScene{R"({"lights": [{"intensity": [1, 2]}]})", "three finite numbers"},
                    BadScene{R"({"lights": [{"intensity": [1, -2, 1]}]})", "none negative"},
                    BadScene{"{\"lights\": [\n{\"intensity\": [1e999, 1, 1]}]}",
                             "scene.json:2: the number 1e999 is too large"},
                    BadScene{R"({"lights": [{"direction": [0, 0, 0]}]})", "zero vector"},
                    BadScene{R"({"lights": [{"radius": 91}]})", "within 0 .. 90"},
                    BadScene{R"({"surface": {"model": "lambret"}})", "did you mean 'lambert'"},
                    BadScene{R"({"surface": {"parameters": {"ks": -1}}})", "ks = -1 is out of range"},
                    BadScene{R"({"surface": {"parameters": {"ks": [1, 2]}}})", "takes 1 or 3 numbers, not 2"},
                    BadScene{R"({"surface": {"parameters": {"order": 8}}})", "order = 8 takes 55"},
                    BadScene{R"({"surface": {"parameters": {"wrong": 1}}})", "no model has a parameter 'wrong'"},
                    BadScene{R"({"surface": {"convention": "camera"}})", "choose one of: sensor, primary"},
                    BadScene{R"({"surface": {"convention": "primary", "W": [1, 2, 3]}})", "nine finite numbers"},
                    BadScene{R"({"surface": {"convention": "primary", "W": [1,1,1, 1,1,1, 0,0,1]}})", "W is singular"},
                    BadScene{R"({"sensor": {"exposure": 1e9}})", "within -16 .. 16"},
                    BadScene{R"({"sensor": {"noise": {"sigma": 1}}})", "scene.sensor.noise"},
                    BadScene{R"({"sensor": {"quantisation": {"bits": 17}}})", "within 1 .. 16"},
                    BadScene{R"({"sensor": {"encoding": {"kind": "sgrb"}}})", "choose one of: linear, srgb, rec709"},
                    BadScene{R"({"sensor": {"response": {"kind": "curve"}}})", "needs its file"},
                    BadScene{R"({"sensor": {"response": {"file": "missing.csv"}}})", "missing.csv"},
                    BadScene{R"({"sensor": {"nose": {}}})", "did you mean 'noise'"},
                    BadScene{R"({"mesh": "missing.obj"})", "missing.obj"},
                    BadScene{R"({"version": 3})", "of version 3 and was written by a newer program"},
                    BadScene{R"({"schema": "reflectance.tour"})", "another kind of file"},
                    BadScene{R"({"reflectance_scene": 2})", "reflectance_scene must be a whole number within 1 .. 1"}));

} // namespace
} // namespace reflectance
