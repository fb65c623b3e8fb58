#include "tests/project/rules.h"

#include "core/base/text.h"

#include <algorithm>
#include <optional>

namespace reflectance::project {
namespace {

/// In the folder, or one of the files NAME.h and NAME.cpp.
bool isBelow(std::string_view path, std::string_view folderOrName)
{
    if (!path.starts_with(folderOrName))
        return false;
    const std::string_view rest = path.substr(folderOrName.size());
    return rest.empty() || rest.front() == '/' || rest.front() == '.';
}

/// Adds what the allowed rooms may include in turn, until nothing is new.
void close(std::map<std::string, std::set<std::string>>& rooms)
{
    for (bool grew = true; grew;) {
        grew = false;
        for (auto& [room, allowed] : rooms)
            for (const std::string& direct : std::set<std::string>(allowed))
                for (const std::string& further : rooms[direct])
                    grew = allowed.insert(further).second || grew;
    }
}

struct Include {
    std::string name;
    bool ours = false; ///< written with quotes
};

std::optional<Include> includeIn(std::string_view line)
{
    constexpr std::string_view directive = "#include ";
    line = trimmed(line);
    if (!line.starts_with(directive) || line.size() < directive.size() + 2)
        return std::nullopt;
    const bool ours = line[directive.size()] == '"';
    line.remove_prefix(directive.size() + 1);
    return Include{std::string(line.substr(0, line.find(ours ? '"' : '>'))), ours};
}

/// Standard headers have neither an ending nor a folder.
bool isStandard(std::string_view header)
{
    return header.find_first_of("./") == std::string_view::npos;
}

std::string problemWithLibrary(const Rules& rules, std::string_view path, const std::string& header)
{
    for (const auto& [beginning, folders] : rules.libraries)
        if (header.starts_with(beginning)) {
            const auto holds = [path](const std::string& folder) { return isBelow(path, folder); };
            return std::any_of(folders.begin(), folders.end(), holds)
                       ? ""
                       : "has its home elsewhere; see docs/architecture.md";
        }
    return isStandard(header) ? "" : "has no row in the libraries of docs/architecture.md";
}

std::string problemWithRoom(const Rules& rules, std::string_view path, const std::string& header)
{
    const std::string from = roomOf(rules, path);
    const std::string to = roomOf(rules, header);
    if (to.empty())
        return header.find('/') == std::string::npos ? "" : "belongs to no room"; // without a folder: made by the build
    const bool allowed = from == to || rules.rooms.at(from).contains(to);
    return allowed ? "" : from + " may not include " + to;
}

} // namespace

Rules parseRules(std::string_view architecture)
{
    Rules rules;
    std::map<std::string, std::set<std::string>>* table = nullptr;
    for (const std::string_view line : split(architecture, '\n')) {
        const auto cells = split(line, '|');
        const std::string_view heading = cells.size() < 4 ? "" : trimmed(cells[1]);
        if (heading.empty())
            table = nullptr;
        else if (heading == "room")
            table = &rules.rooms;
        else if (heading == "headers")
            table = &rules.libraries;
        else if (table)
            for (const std::string& name : inBackticks(heading))
                for (auto& entry = (*table)[name]; const std::string& allowed : inBackticks(cells[2]))
                    entry.insert(allowed);
    }
    close(rules.rooms);
    return rules;
}

std::string roomOf(const Rules& rules, std::string_view path)
{
    std::string innermost;
    for (const auto& [room, allowed] : rules.rooms)
        if (isBelow(path, room) && room.size() > innermost.size())
            innermost = room;
    return innermost;
}

std::vector<std::string> forbiddenIncludes(const Rules& rules, const SourceFile& file)
{
    std::vector<std::string> problems;
    if (roomOf(rules, file.path).empty())
        return {file.path + ": belongs to no room of docs/architecture.md"};
    long number = 0;
    for (const std::string_view line : split(file.text, '\n')) {
        ++number;
        const auto include = includeIn(line);
        if (!include)
            continue;
        const std::string problem = include->ours ? problemWithRoom(rules, file.path, include->name)
                                                  : problemWithLibrary(rules, file.path, include->name);
        if (!problem.empty())
            problems.push_back(file.path + ":" + std::to_string(number) + ": " + include->name + ": " + problem);
    }
    return problems;
}

std::string roomInCircle(const Rules& rules)
{
    for (const auto& [room, allowed] : rules.rooms)
        if (allowed.contains(room))
            return room;
    return {};
}

} // namespace reflectance::project
