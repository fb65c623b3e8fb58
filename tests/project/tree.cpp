#include "tests/project/tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace reflectance::project {
namespace {

namespace fs = std::filesystem;

const fs::path& folderOfProject()
{
    static const fs::path folder = PROJECT_FOLDER;
    return folder;
}

} // namespace

std::vector<SourceFile> filesBelow(const std::vector<std::string>& folders, const std::vector<std::string>& endings)
{
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folderOfProject() / folder)) {
            const std::string path = fs::relative(entry.path(), folderOfProject()).generic_string();
            const auto ends = [&path](const std::string& ending) { return path.ends_with(ending); };
            if (entry.is_regular_file() && std::any_of(endings.begin(), endings.end(), ends))
                files.push_back({path, textOf(path)});
        }
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::string textOf(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(folderOfProject() / path, std::ios::binary).rdbuf();
    return text.str();
}

bool exists(const std::string& path)
{
    return fs::exists(folderOfProject() / path);
}

std::vector<std::string> inBackticks(std::string_view text)
{
    std::vector<std::string> pieces;
    for (std::size_t open = text.find('`'); open != std::string_view::npos;) {
        const std::size_t close = text.find('`', open + 1);
        if (close == std::string_view::npos)
            break;
        pieces.emplace_back(text.substr(open + 1, close - open - 1));
        open = text.find('`', close + 1);
    }
    return pieces;
}

} // namespace reflectance::project
