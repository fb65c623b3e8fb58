#include "tests/project/papers.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace reflectance::project {
namespace {

/// Without <!-- comments -->.
std::string visible(std::string text)
{
    for (std::size_t open = text.find("<!--"); open != std::string::npos; open = text.find("<!--", open)) {
        const std::size_t close = text.find("-->", open);
        text.erase(open, close == std::string::npos ? close : close + 3 - open);
    }
    return text;
}

/// What stands in ](...).
std::vector<std::string> linksIn(std::string_view text)
{
    std::vector<std::string> links;
    for (std::size_t at = text.find("]("); at != std::string_view::npos; at = text.find("](", at + 1)) {
        const std::size_t close = text.find(')', at);
        if (close != std::string_view::npos)
            links.emplace_back(text.substr(at + 2, close - at - 2));
    }
    return links;
}

/// The name under which a heading is linked: lower case, blanks to hyphens, punctuation dropped.
std::string anchorOf(std::string_view heading)
{
    std::string anchor;
    for (const char letter : lowered(trimmed(heading)))
        if (letter == ' ')
            anchor += '-';
        else if (std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_')
            anchor += letter;
    return anchor;
}

bool hasHeading(std::string_view text, std::string_view anchor)
{
    const auto lines = split(text, '\n');
    return std::any_of(lines.begin(), lines.end(), [anchor](std::string_view line) {
        return line.starts_with('#') && anchorOf(line.substr(line.find_first_not_of('#'))) == anchor;
    });
}

std::string resolved(const SourceFile& paper, const std::string& target)
{
    if (target.empty())
        return paper.path;
    return (std::filesystem::path(paper.path).parent_path() / target).lexically_normal().generic_string();
}

/// A pair of files may be named without ending.
bool stands(const std::string& path)
{
    return exists(path) || exists(path + ".h");
}

bool looksLikePath(std::string_view text)
{
    constexpr std::array folders{"app/",     "cmake/",   "core/",  "docs/", "meshes/",
                                 "scripts/", "shaders/", "tests/", "tools/"};
    const auto starts = [text](std::string_view folder) { return text.starts_with(folder); };
    return std::any_of(folders.begin(), folders.end(), starts) &&
           text.find_first_of("*<>{} ") == std::string_view::npos;
}

} // namespace

std::vector<std::string> brokenLinks(const SourceFile& paper)
{
    std::vector<std::string> problems;
    for (const std::string& link : linksIn(visible(paper.text))) {
        if (link.find("://") != std::string::npos || link.starts_with("mailto:"))
            continue;
        const std::size_t hash = std::min(link.find('#'), link.size());
        const std::string target = resolved(paper, link.substr(0, hash));
        const std::string anchor = link.substr(std::min(hash + 1, link.size()));
        const bool itself = target == paper.path;
        const std::string text = itself ? paper.text : textOf(target);
        if (!itself && !exists(target))
            problems.push_back(paper.path + ": there is no file " + link);
        else if (!anchor.empty() && !hasHeading(text, anchor))
            problems.push_back(paper.path + ": there is no heading " + link);
    }
    return problems;
}

std::vector<std::string> missingPaths(const SourceFile& paper)
{
    std::vector<std::string> problems;
    for (const std::string& name : inBackticks(visible(paper.text)))
        if (looksLikePath(name) && !stands(name.substr(0, name.find(':'))))
            problems.push_back(paper.path + ": there is no " + name);
    return problems;
}

} // namespace reflectance::project
