// Papers lead somewhere: links, headings and the paths that they name exist.
#include "tests/project/papers.h"

#include <gtest/gtest.h>

namespace reflectance::project {
namespace {

std::vector<SourceFile> papers()
{
    std::vector<SourceFile> all = filesBelow({"app", "core", "docs", "meshes", "shaders", "tests", "tools"}, {".md"});
    for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
        all.push_back({name, textOf(name)});
    return all;
}

TEST(Papers, LinksLeadSomewhere)
{
    for (const SourceFile& paper : papers()) {
        EXPECT_FALSE(paper.text.empty()) << paper.path;
        for (const std::string& problem : brokenLinks(paper))
            ADD_FAILURE() << problem;
    }
}

TEST(Papers, NamedFilesExist)
{
    for (const SourceFile& paper : papers())
        for (const std::string& problem : missingPaths(paper))
            ADD_FAILURE() << problem;
}

TEST(Papers, CatchesPlantedFaults)
{
    const SourceFile good{"docs/x.md", "# A heading\n[a](../README.md) [b](#a-heading) [c](https://example.org/x) "
                                       "<!-- [d](nowhere.md) --> `core/base/text.h:12` `core/<room>/x.h`"};
    EXPECT_EQ(brokenLinks(good).size(), 0U);
    EXPECT_EQ(missingPaths(good).size(), 0U);
    EXPECT_EQ(brokenLinks({"docs/x.md", "[a](nowhere.md)"}).size(), 1U);
    EXPECT_EQ(brokenLinks({"docs/x.md", "[a](README.md)"}).size(), 1U) << "relative to the paper's folder";
    EXPECT_EQ(brokenLinks({"docs/x.md", "[a](#nowhere)"}).size(), 1U);
    EXPECT_EQ(missingPaths({"docs/x.md", "`core/base/nowhere.h`"}).size(), 1U);
}

} // namespace
} // namespace reflectance::project
