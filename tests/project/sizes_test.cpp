// Files stay small enough to be read at once.
#include "tests/project/tree.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace reflectance::project {
namespace {

constexpr long longest = 500; ///< lines of any file
constexpr long typical = 120; ///< lines of the median file

long linesOf(const SourceFile& file)
{
    return std::count(file.text.begin(), file.text.end(), '\n');
}

std::vector<SourceFile> code()
{
    return filesBelow({"app", "cmake", "core", "scripts", "shaders", "tests", "tools"},
                      {".h", ".cpp", ".cmake", ".glsl", ".vert", ".frag", ".py", ".sh", "CMakeLists.txt"});
}

TEST(Sizes, NoFileIsTooLong)
{
    for (const SourceFile& file : code())
        EXPECT_LE(linesOf(file), longest) << file.path << ": divide it";
}

TEST(Sizes, TheMedianFileIsShort)
{
    std::vector<long> lines;
    for (const SourceFile& file : code())
        lines.push_back(linesOf(file));
    ASSERT_FALSE(lines.empty());
    const auto middle = lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2);
    std::nth_element(lines.begin(), middle, lines.end());
    EXPECT_LT(*middle, typical);
}

TEST(Sizes, CountsLines)
{
    EXPECT_EQ(linesOf({"x.h", std::string(501, '\n')}), 501);
    EXPECT_GT(linesOf({"x.h", std::string(501, '\n')}), longest) << "a planted file that is too long";
}

} // namespace
} // namespace reflectance::project
