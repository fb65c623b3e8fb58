// Result holds a value or a sentence that names its place.
#include "core/base/result.h"

#include <gtest/gtest.h>
#include <memory>

namespace reflectance {
namespace {

TEST(Result, SentenceNamesWhatIsKnownOfThePlace)
{
    EXPECT_EQ((Error{"wrong", "a.obj", 7}).sentence(), "a.obj:7: wrong");
    EXPECT_EQ((Error{"wrong", "a.obj"}).sentence(), "a.obj: wrong");
    EXPECT_EQ((Error{"wrong"}).sentence(), "wrong");
}

TEST(Result, ASentenceIsOneLineWhateverItQuotes)
{
    EXPECT_EQ((Error{"unknown key 'a\nb\x1b[2J'", "x\r.json", 1}).sentence(), "x?.json:1: unknown key 'a?b?[2J'");
    const std::string longest(600, 'x');
    EXPECT_EQ(Error{longest}.sentence(), longest);
    EXPECT_EQ(Error{"key '" + std::string(100000, 'x') + "' is unknown"}.sentence().size(), 605U);
}

TEST(Result, MovesItsValueOut)
{
    Result<std::unique_ptr<int>> result = std::make_unique<int>(3);
    ASSERT_TRUE(result);
    const std::unique_ptr<int> taken = *std::move(result);
    EXPECT_EQ(*taken, 3);
}

TEST(Result, WithoutValue)
{
    EXPECT_TRUE(Result<void>());
    const Result<void> failed = Error{"wrong"};
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().message, "wrong");
}

} // namespace
} // namespace reflectance
