// The program carries its shaders and meshes.
#include "core/base/embedded.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

TEST(Embedded, HoldsTheModelTextsAndTheMug)
{
    EXPECT_NE(embeddedText("reflectance/hybrid.glsl").find("vec3 shade("), std::string_view::npos);
    EXPECT_NE(embeddedText("reflectance/models.txt").find("lambert\n"), std::string_view::npos);
    EXPECT_GT(embeddedText("meshes/mug.obj").size(), 1000U);
}

TEST(EmbeddedDeathTest, UnknownNameIsAProgrammingError)
{
    EXPECT_DEATH((void)embeddedText("no such file"), "no such file");
}

} // namespace
} // namespace reflectance
