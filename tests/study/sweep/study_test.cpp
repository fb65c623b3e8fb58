// Studies: which cells they have, and what is wrong with those that cannot be swept.
#include "core/scene/scene_file.h"
#include "core/study/sweep/study.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

Study studyOf(const std::string& text)
{
    const auto study = parseStudy(text, "study.json", "");
    EXPECT_TRUE(study) << study.error().sentence();
    return study ? *study : Study();
}

Scene sceneOf(const Cell& cell)
{
    const auto scene = parseScene(cell.scene, "cell", "");
    EXPECT_TRUE(scene) << scene.error().sentence();
    return scene ? *scene : defaultScene();
}

TEST(Studies, CellsAreAllCombinationsWithTheLastAxisFastest)
{
    const Study study = studyOf(R"({"axes": [{"axis": "model", "values": ["lambert", "phong"]},
                                             {"axis": "n", "values": [1, 2, 3]},
                                             {"axis": "renderer", "values": ["double", "simd"]}]})");
    ASSERT_EQ(cellCount(study), 12U);
    EXPECT_EQ(cellAt(study, 0).labels, (std::vector<std::string>{"lambert", "1"}));
    EXPECT_EQ(cellAt(study, 1).labels, (std::vector<std::string>{"lambert", "1"}));
    EXPECT_EQ(cellAt(study, 0).renderer, CellRenderer::Double);
    EXPECT_EQ(cellAt(study, 1).renderer, CellRenderer::Simd);
    EXPECT_EQ(cellAt(study, 2).labels, (std::vector<std::string>{"lambert", "2"}));
    EXPECT_EQ(cellAt(study, 11).labels, (std::vector<std::string>{"phong", "3"}));
    const Scene last = sceneOf(cellAt(study, 11));
    EXPECT_EQ(last.surface.model, "phong");
    EXPECT_EQ(last.surface.values.at("n"), std::vector<double>{3.0});
}

TEST(Studies, RangesEndWhereTheySay)
{
    const Study study = studyOf(R"({"axes": [{"axis": "n", "from": 1, "to": 1e4, "steps": 5, "scale": "log"},
                                             {"axis": "exposure", "from": -1, "to": 1, "steps": 3}]})");
    ASSERT_EQ(cellCount(study), 15U);
    for (std::uint64_t i = 0; i < 5; ++i) {
        const double n = sceneOf(cellAt(study, 3 * i)).surface.values.at("n")[0];
        // pow is within an ulp or two, the product rounds once more.
        EXPECT_NEAR(n, std::pow(10.0, static_cast<double>(i)), 1e-12 * n) << i;
    }
    EXPECT_EQ(sceneOf(cellAt(study, 14)).surface.values.at("n")[0], 1e4) << "the end is exact";
    EXPECT_EQ(sceneOf(cellAt(study, 1)).sensor.exposure, 0.0);
    EXPECT_EQ(studyOf(R"({"axes": [{"axis": "n", "from": 7, "to": 9, "steps": 1}]})").axes[0].labels[0], "7.0");
}

TEST(Studies, ObjectsAreMergedAndNamesAreLabels)
{
    const Study study = studyOf(R"({
        "scene": {"lights": [{"kind": "directional", "direction": [0, 0, 1]}]}, "samples": 9,
        "axes": [{"axis": "lights.0.intensity", "values": [[1, 0, 0], [0, 0, 1]], "names": ["red", "blue"]},
                 {"axis": "camera", "values": [{"field_of_view": 20}]},
                 {"axis": "size", "values": [[8, 4], [16, 8]]}]})");
    const Cell cell = cellAt(study, 3);
    EXPECT_EQ(cell.labels[0], "blue");
    EXPECT_EQ(cell.settings, (RenderSettings{16, 8, 3}));
    const Scene scene = sceneOf(cell);
    EXPECT_EQ(scene.lights[0].intensity, (Vec3d{0.0, 0.0, 1.0}));
    EXPECT_EQ(scene.camera.fieldOfView, 20.0);
    EXPECT_EQ(scene.camera.eye, defaultScene().camera.eye) << "an object changes what it names only";
}

TEST(Studies, ALibrarySurfaceBringsItsOwnModel)
{
    const Study study = studyOf(R"({"scene": {"surface": {"model": "phong", "parameters": {"n": 3}}},
        "axes": [{"axis": "library", "values": ["curet_oren_nayar/velvet"]}]})");
    const Scene scene = sceneOf(cellAt(study, 0));
    EXPECT_EQ(scene.surface.model.substr(0, 10), "oren_nayar");
}

struct Wrong {
    const char* text;
    const char* says;
};

class WrongStudies : public testing::TestWithParam<Wrong> {};

TEST_P(WrongStudies, AreRefusedInOneSentence)
{
    const auto study = parseStudy(GetParam().text, "study.json", "");
    ASSERT_FALSE(study);
    EXPECT_NE(study.error().sentence().find(GetParam().says), std::string::npos) << study.error().sentence();
    EXPECT_EQ(study.error().sentence().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongStudies,
    testing::Values(
        Wrong{"{", "study.json:1: not a JSON study"}, Wrong{"[]", "study is not an object"},
        Wrong{R"({"axes": []})", "nothing to sweep"}, Wrong{R"({"axis": []})", "unknown key 'axis'"},
        Wrong{R"({"axes": [{"values": [1]}]})", "an axis has no name"},
        Wrong{R"({"axes": [{"axis": "n", "values": []}]})", "no cells"},
        Wrong{R"({"axes": [{"axis": "n", "from": 1, "to": 2}]})", "needs values, or from, to and steps"},
        Wrong{R"({"axes": [{"axis": "n", "from": 1, "to": 2, "steps": 0}]})", "steps must be a whole number within 1"},
        Wrong{R"({"axes": [{"axis": "n", "from": 0, "to": 2, "steps": 3, "scale": "log"}]})", "logarithmic"},
        Wrong{R"({"axes": [{"axis": "n", "from": 1, "values": [1]}]})", "unknown key 'from'"},
        Wrong{R"({"axes": [{"axis": "n", "values": [1, 2], "names": ["one"]}]})", "as many names"},
        Wrong{R"({"axes": [{"axis": "modle", "values": [1]}]})", "did you mean 'model'"},
        Wrong{R"({"axes": [{"axis": "lights.9.intensity", "values": [1]}]})", "neither a parameter nor a place"},
        Wrong{R"({"axes": [{"axis": "renderer", "values": ["half"]}]})", "\"half\" will not do; a renderer is double"},
        Wrong{R"({"axes": [{"axis": "samples", "values": [5]}]})", "samples are 1, 4"},
        Wrong{R"({"axes": [{"axis": "size", "values": [[4294967552, 8]]}]})", "a size is [width, height]"},
        Wrong{R"({"axes": [{"axis": "view", "values": [30]}]})", "a view is [azimuth, elevation]"},
        Wrong{R"({"axes": [{"axis": "n", "values": [1]}, {"axis": "n", "values": [2]}]})",
              "both set /surface/parameters/n"},
        Wrong{R"({"axes": [{"axis": "lights", "values": [[]]}, {"axis": "lights.0.radius", "values": [2]}]})",
              "both set /lights/0/radius"},
        Wrong{R"({"axes": [{"axis": "view", "values": [[0, 0]]}, {"axis": "camera.eye", "values": [[1, 2, 3]]}]})",
              "both set /camera/eye"},
        Wrong{R"({"axes": [{"axis": "model", "values": ["lambert"]}, {"axis": "n", "values": [1]}]})",
              "axis 'n' changes nothing"},
        Wrong{R"({"axes": [{"axis": "model", "values": ["lambert"]}, {"axis": "library", "values": ["x"]}]})",
              "a library surface has its own model"},
        Wrong{R"({"scene": 3, "axes": [{"axis": "n", "values": [1]}]})", "study.scene must be"},
        Wrong{R"({"scene": "nowhere.json", "axes": [{"axis": "n", "values": [1]}]})", "nowhere.json"},
        Wrong{R"({"scene": {"exposre": 1}, "axes": [{"axis": "n", "values": [1]}]})", "unknown key 'exposre'"},
        Wrong{
            R"({"axes": [{"axis": "n", "from": 1, "to": 2, "steps": 100001}, {"axis": "ks", "from": 0, "to": 1, "steps": 100001},
                 {"axis": "exposure", "from": 0, "to": 1, "steps": 100001}]})",
            "more than 1e15 cells"}));

} // namespace
} // namespace reflectance
