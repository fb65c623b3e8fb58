// Surroundings from files.
#include "core/illumination/environment.h"
#include "core/image/picture_file.h"

#include <array>
#include <filesystem>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

std::string placeFor(const std::string& name)
{
    return testing::TempDir() + "reflectance_environment_" + name;
}

TEST(EnvironmentFile, AnExrIsLoadedAsItIs)
{
    Image image(4, 2);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<float>(i) * 100.0F;
    const std::string path = placeFor("map.exr");
    ASSERT_TRUE(writeLinear(path, image));
    const auto environment = loadEnvironment(path);
    ASSERT_TRUE(environment) << environment.error().sentence();
    EXPECT_EQ(environment->kind, EnvironmentKind::Map);
    EXPECT_EQ(environment->file, path);
    EXPECT_EQ(environment->map->rgb, image.rgb);
    EXPECT_EQ(environment->radiance, Vec3d(1, 1, 1));
    std::filesystem::remove(path);
}

TEST(EnvironmentFile, APngIsRefusedForItHoldsNoRadiance)
{
    const std::string path = placeFor("map.png");
    const std::array<std::uint8_t, 6> codes{1, 2, 3, 4, 5, 6};
    ASSERT_TRUE(writePng(path, 2, 1, codes));
    const auto environment = loadEnvironment(path);
    ASSERT_FALSE(environment);
    EXPECT_EQ(environment.error().file, path);
    EXPECT_NE(environment.error().message.find("linear"), std::string::npos);
    std::filesystem::remove(path);
}

TEST(EnvironmentFile, AMissingFileIsSaidSo)
{
    const auto environment = loadEnvironment(placeFor("nowhere.exr"));
    ASSERT_FALSE(environment);
    EXPECT_NE(environment.error().sentence().find("there is no such file"), std::string::npos);
}

} // namespace
} // namespace reflectance
