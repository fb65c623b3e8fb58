#include "app/explorer/user_folders.h"

#include "core/base/text.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

std::string environmentVariable(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// The folder that `variable` names, else `usual` below the home folder; empty without a home.
fs::path baseFolder(const char* variable, const char* usual)
{
    const fs::path given = environmentVariable(variable);
    if (given.is_absolute()) // the specification says to ignore relative paths
        return given;
    const std::string home = environmentVariable("HOME");
    return home.empty() ? fs::path() : fs::path(home) / usual;
}

fs::path cacheFolder()
{
    const fs::path cache = baseFolder("XDG_CACHE_HOME", ".cache");
    return cache.empty() ? cache : cache / "reflectance";
}

fs::path configHome()
{
    return baseFolder("XDG_CONFIG_HOME", ".config");
}

bool isFolder(const fs::path& path)
{
    std::error_code ignored;
    return !path.empty() && fs::is_directory(path, ignored);
}

/// Letters, digits and a few signs: a name that needs no quoting anywhere.
std::string plain(std::string name)
{
    for (char& c : name) {
        const bool ascii = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (!ascii && c != '_' && c != '-' && c != '.')
            c = '_';
    }
    return name;
}

} // namespace

fs::path settingsFolder()
{
    const fs::path config = configHome();
    return config.empty() ? config : config / "reflectance";
}

fs::path stateFolder()
{
    const fs::path state = baseFolder("XDG_STATE_HOME", ".local/state");
    return state.empty() ? state : state / "reflectance";
}

fs::path programsFolder()
{
    const fs::path cache = cacheFolder();
    return cache.empty() ? cache : cache / "programs";
}

fs::path backendsFile()
{
    const fs::path cache = cacheFolder();
    return cache.empty() ? cache : cache / "backends";
}

fs::path picturesFolderIn(std::string_view userDirs, const std::string& home)
{
    for (std::string_view line : split(userDirs, '\n')) {
        constexpr std::string_view key = "XDG_PICTURES_DIR=";
        line = trimmed(line);
        if (line.substr(0, key.size()) != key)
            continue;
        line = trimmed(line.substr(key.size()));
        if (line.size() >= 2 && line.front() == '"' && line.back() == '"')
            line = line.substr(1, line.size() - 2);
        constexpr std::string_view homeSign = "$HOME";
        if (line.substr(0, homeSign.size()) == homeSign)
            return home + std::string(line.substr(homeSign.size()));
        return fs::path(line).is_absolute() ? fs::path(line) : fs::path();
    }
    return {};
}

fs::path picturesFolder()
{
    const std::string home = environmentVariable("HOME");
    std::ifstream file(configHome() / "user-dirs.dirs");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const fs::path& folder : {picturesFolderIn(text, home), fs::path(home) / "Pictures", fs::path(home)})
        if (isFolder(folder))
            return folder;
    return fs::path(".");
}

fs::path freeName(const fs::path& folder, const std::string& mesh, const std::string& model, const std::string& ending)
{
    const std::string start = "reflectance-" + plain(mesh) + "-" + plain(model) + "-";
    for (long n = 1;; ++n) {
        const fs::path path = folder / (start + std::to_string(n) + ending);
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(path, ignored)))
            return path;
    }
}

} // namespace reflectance::explorer
