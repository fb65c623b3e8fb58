// Strange and damaged scene files: each line of the tables says what must come of it.
#include "core/scene/scene_file.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

struct Case {
    const char* what;
    std::string text;
    const char* sentence; ///< part of the refusal
};

std::string nested(std::size_t depth)
{
    return std::string(depth, '[') + std::string(depth, ']');
}

std::vector<Case> damagedScenes()
{
    constexpr std::size_t deep = 100'000; // a reader that calls itself for each level would not come back
    const std::string zero(1, '\0');
    return {
        {"binary garbage", std::string("\x7F\x45\x4C\x46\0\1\2", 7), "not a JSON scene"},
        {"UTF-16", "\xFF\xFE{" + zero + "}" + zero, "not a JSON scene"},
        {"no UTF-8 in a text", "{\"mesh\": \"\xC3\x28\"}", "not a JSON scene"},
        {"two scenes in a row", "{}{}", "not a JSON scene"},
        {"a comment", "{} // scene", "not a JSON scene"},
        {"NaN", R"({"sensor": {"exposure": NaN}})", "not a JSON scene"},
        {"brackets that never close", std::string(deep, '['), "not a JSON scene"},
        {"100,000 brackets", nested(deep), "scene is not an object"},
        {"100,000 brackets for a word", R"({"background": {"kind": )" + nested(deep) + "}}",
         "scene.background.kind must be a text in quotes; choose one of: plain, environment"},
        {"100,000 brackets for a number", R"({"sensor": {"exposure": )" + nested(deep) + "}}", "must be a number"},
        {"100,000 brackets for a list", R"({"camera": {"eye": )" + nested(deep) + "}}", "three finite numbers"},
        {"a key of 10 MB", "{\"" + std::string(10'000'000, 'x') + "\": 1}", "has an unknown key 'xxx"},
        {"a key of two lines", "{\"a\\nb\": 1}", "unknown key 'a?b'"},
        {"a mesh of two lines", R"({"mesh": "a\nb\u001b[2J"})", "a?b?[2J"},
        {"a mesh with a zero in its name", "{\"mesh\": \"mug\\u0000.obj\"}", "no such file"},
        {"a mesh that is a folder", R"({"mesh": "/"})", "folder"},
        {"a mesh that never ends", R"({"mesh": "/dev/zero"})", "device"},
        {"a picture that never ends", R"({"environment": {"kind": "map", "file": "/dev/zero"}})", "device"},
        {"a whole number beyond 64 bits", R"({"reflectance_scene": 18446744073709551617})", "whole number"},
        {"a whole number beyond 63 bits", R"({"reflectance_scene": 18446744073709551615})", "whole number"},
    };
}

TEST(SceneCorpus, DamagedScenesAreRefusedInOneSentence)
{
    for (const Case& file : damagedScenes()) {
        const auto scene = parseScene(file.text, "scene.json", "/nonexistent");
        ASSERT_FALSE(scene) << file.what;
        const std::string sentence = scene.error().sentence();
        EXPECT_NE(sentence.find(file.sentence), std::string::npos) << file.what << ": " << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << file.what;
        EXPECT_LT(sentence.size(), 800U) << file.what << ": a sentence, not the file";
    }
}

TEST(SceneCorpus, EveryShorterSceneIsRefused)
{
    const std::string whole = sceneText(defaultScene(), "");
    // The last two characters are the outer bracket and the line end.
    for (std::size_t length = 0; length + 2 <= whole.size(); ++length)
        ASSERT_FALSE(parseScene(whole.substr(0, length), "scene.json", "")) << length;
    EXPECT_TRUE(parseScene(whole.substr(0, whole.size() - 1), "scene.json", "")) << "without its line end it is whole";
}

TEST(SceneCorpus, EveryWriterIsUnderstood)
{
    for (const char* text : {"{}", "\xEF\xBB\xBF{}", "{\r\n}\r\n", "\t{\r}", "{\"lights\": []}",
                             "{\"sensor\": {\"exposure\": 9}, \"sensor\": {\"exposure\": 2}}"}) {
        const auto scene = parseScene(text, "scene.json", "");
        EXPECT_TRUE(scene) << text << ": " << (scene ? "" : scene.error().sentence());
    }
}

TEST(SceneCorpus, WhatIsNoFileIsRefused)
{
    std::string folder = (fs::temp_directory_path() / "reflectance-scene-XXXXXX").string();
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string pipe = folder + "/pipe.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::ofstream(folder + "/good.json") << "{}";
    EXPECT_FALSE(loadScene(folder));
    EXPECT_FALSE(loadScene(pipe)) << "opening it would wait for ever";
    EXPECT_FALSE(loadScene(folder + "/missing.json"));
    EXPECT_TRUE(loadScene(folder + "/good.json"));
    fs::remove_all(folder);
}

} // namespace
} // namespace reflectance
