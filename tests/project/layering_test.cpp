// Includes go down, and each library has its home: docs/architecture.md says where, this test holds the code to it.
#include "tests/project/rules.h"

#include <gtest/gtest.h>

namespace reflectance::project {
namespace {

const Rules& rules()
{
    static const Rules parsed = parseRules(textOf("docs/architecture.md"));
    return parsed;
}

TEST(Layering, TheTablesAreReadAndHaveNoCircle)
{
    EXPECT_GT(rules().rooms.size(), 10U);
    EXPECT_GT(rules().libraries.size(), 10U);
    EXPECT_TRUE(rules().rooms.at("core/study").contains("core/base")) << "through others";
    EXPECT_EQ(roomInCircle(rules()), "");
}

TEST(Layering, EveryIncludeIsAllowed)
{
    const auto files = filesBelow({"core", "app", "tools"}, {".h", ".cpp"});
    ASSERT_FALSE(files.empty());
    for (const SourceFile& file : files)
        for (const std::string& problem : forbiddenIncludes(rules(), file))
            ADD_FAILURE() << problem;
}

TEST(Layering, EveryRoomStands)
{
    for (const auto& [room, allowed] : rules().rooms)
        EXPECT_TRUE(exists(room) || exists(room + ".h")) << room << " is named in docs/architecture.md";
}

TEST(Layering, CatchesPlantedFaults)
{
    const auto problemsOf = [](const char* path, const char* text) { return forbiddenIncludes(rules(), {path, text}); };
    EXPECT_EQ(problemsOf("core/base/x.h", "#include <vector>\n#include \"core/base/text.h\"\n").size(), 0U);
    EXPECT_EQ(problemsOf("core/math/x.h", "\n#include \"core/scene/scene.h\"\n"),
              std::vector<std::string>{"core/math/x.h:2: core/scene/scene.h: core/math may not include core/scene"});
    EXPECT_EQ(problemsOf("core/image/x.h", "#include \"core/sensor/sensor.h\"").size(), 1U) << "siblings";
    EXPECT_EQ(problemsOf("core/study/x.h", "#include \"app/cli/verbs.h\"").size(), 1U);
    EXPECT_EQ(problemsOf("core/scene/x.cpp", "#include <GLFW/glfw3.h>").size(), 1U);
    EXPECT_EQ(problemsOf("core/render/gl/x.cpp", "  #include <imgui.h>").size(), 1U);
    EXPECT_EQ(problemsOf("core/image/x.cpp", "#include <neverheardof/x.h>").size(), 1U);
    EXPECT_EQ(problemsOf("core/attic/x.cpp", "").size(), 1U);
    EXPECT_EQ(problemsOf("core/base/x.h", "#include \"attic/x.h\"").size(), 1U);

    Rules circle;
    circle.rooms = {{"a", {"b", "a"}}, {"b", {"a", "b"}}};
    EXPECT_EQ(roomInCircle(circle), "a");
    EXPECT_EQ(roomInCircle(parseRules("| room | may | x |\n| `a` | `b` | |\n| `b` | `a` | |\n")), "a");
}

} // namespace
} // namespace reflectance::project
