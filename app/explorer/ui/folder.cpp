#include "app/explorer/ui/folder.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace reflectance::explorer {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> endings = {{
    {".obj", "mesh"},
    {".ply", "mesh"},
    {".off", "mesh"},
    {".stl", "mesh"},
    {".json", "scene"},
    {".png", "saved picture"},
    {".exr", "environment"},
    {".hdr", "environment"},
    {".csv", "measurement"},
    {".binary", "measurement"},
    {".bsdf", "measurement"},
    {".brdf", "measurement"},
}};

FolderEntry entryOf(const fs::directory_entry& file)
{
    // A file may vanish between listing and asking; then it is a file of size 0.
    std::error_code ignored;
    FolderEntry entry{file.path().filename().string(), file.is_directory(ignored), 0};
    if (!entry.isFolder)
        if (const std::uintmax_t size = file.file_size(ignored); !ignored)
            entry.size = size;
    return entry;
}

bool comesBefore(const FolderEntry& a, const FolderEntry& b)
{
    if (a.isFolder != b.isFolder)
        return a.isFolder;
    const std::string x = lowered(a.name), y = lowered(b.name);
    return x != y ? x < y : a.name < b.name;
}

std::string withHome(std::string_view typed)
{
    if (typed == "~" || typed.starts_with("~/"))
        return homeFolder().string() + std::string(typed.substr(1));
    return std::string(typed);
}

} // namespace

fs::path homeFolder()
{
    const char* home = std::getenv("HOME");
    return home && *home ? fs::path(home) : fs::path("/");
}

std::string_view kindOfFile(std::string_view name)
{
    const std::string lower = lowered(name);
    const auto found =
        std::find_if(endings.begin(), endings.end(), [&](const auto& e) { return lower.ends_with(e.first); });
    return found == endings.end() ? std::string_view() : found->second;
}

Result<std::vector<FolderEntry>> listFolder(const fs::path& folder, bool everyFile)
{
    std::error_code problem;
    std::vector<FolderEntry> entries;
    fs::directory_iterator file(folder, problem);
    for (; !problem && file != fs::directory_iterator(); file.increment(problem)) {
        FolderEntry entry = entryOf(*file);
        if (!entry.name.starts_with('.') && (entry.isFolder || everyFile || !kindOfFile(entry.name).empty()))
            entries.push_back(std::move(entry));
    }
    if (problem)
        return Error{"this folder cannot be read: " + problem.message(), folder.string()};
    std::sort(entries.begin(), entries.end(), comesBefore);
    return entries;
}

TypedPlace placeOf(const fs::path& folder, std::string_view typed)
{
    if (typed == "~")
        return {homeFolder(), {}};
    const std::string path = withHome(typed);
    const std::size_t slash = path.rfind('/');
    if (slash == path.npos)
        return {folder, path};
    return {(folder / path.substr(0, slash + 1)).lexically_normal(), path.substr(slash + 1)};
}

std::vector<FolderEntry> matching(std::span<const FolderEntry> entries, std::string_view leaf)
{
    const std::string wanted = lowered(leaf);
    std::vector<FolderEntry> matches;
    std::copy_if(entries.begin(), entries.end(), std::back_inserter(matches),
                 [&](const FolderEntry& entry) { return lowered(entry.name).find(wanted) != std::string::npos; });
    return matches;
}

std::string completed(std::string_view typed, std::span<const FolderEntry> entries)
{
    const std::size_t slash = typed.rfind('/');
    const std::string_view stem = slash == typed.npos ? std::string_view() : typed.substr(0, slash + 1);
    const std::string_view leaf = typed.substr(stem.size());
    std::vector<const FolderEntry*> candidates;
    for (const FolderEntry& entry : entries)
        if (entry.name.starts_with(leaf))
            candidates.push_back(&entry);
    if (candidates.empty())
        return std::string(typed);
    std::string common = candidates[0]->name;
    for (const FolderEntry* entry : candidates)
        common.resize(static_cast<std::size_t>(
            std::mismatch(common.begin(), common.end(), entry->name.begin(), entry->name.end()).first -
            common.begin()));
    const bool intoFolder = candidates.size() == 1 && candidates[0]->isFolder;
    return std::string(stem) + common + (intoFolder ? "/" : "");
}

std::string readableSize(std::uintmax_t bytes)
{
    const auto size = static_cast<double>(bytes);
    if (bytes < 1000)
        return std::to_string(bytes) + " B";
    return size < 1e6   ? general(size / 1e3, 3) + " kB"
           : size < 1e9 ? general(size / 1e6, 3) + " MB"
                        : general(size / 1e9, 3) + " GB";
}

} // namespace reflectance::explorer
