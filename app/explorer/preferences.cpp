#include "app/explorer/preferences.h"

#include "core/base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t mostRecentFiles = 10;

template <class Number> void read(const json& object, const char* key, Number& value, Number least, Number most)
{
    const auto found = object.find(key);
    if (found != object.end() && found->is_number())
        value = static_cast<Number>(
            std::clamp(found->get<double>(), static_cast<double>(least), static_cast<double>(most)));
}

void read(const json& object, const char* key, bool& value)
{
    const auto found = object.find(key);
    if (found != object.end() && found->is_boolean())
        value = found->get<bool>();
}

fs::path fileIn(const fs::path& folder)
{
    return folder / "preferences.json";
}

} // namespace

Result<Preferences> parsePreferences(std::string_view text, const std::string& file)
{
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object())
        return Error{"the preferences are not readable; the defaults are used instead", file};
    Preferences preferences;
    read(object, "windowWidth", preferences.windowWidth, 320, 16384);
    read(object, "windowHeight", preferences.windowHeight, 240, 16384);
    read(object, "panelWidth", preferences.panelWidth, 100.0F, 4000.0F);
    read(object, "workbenchHeight", preferences.workbenchHeight, 100.0F, 4000.0F);
    if (const auto page = object.find("workbenchPage"); page != object.end() && page->is_string())
        preferences.workbenchPage = page->get<std::string>();
    read(object, "interfaceScale", preferences.interfaceScale, 0.0F, 4.0F);
    read(object, "tourStep", preferences.tourStep, 1, 100);
    read(object, "samplesPerAxis", preferences.samplesPerAxis, 1, 8);
    read(object, "showLightHandles", preferences.showLightHandles);
    const auto recent = object.find("recentFiles");
    if (recent != object.end() && recent->is_array())
        for (const json& entry : *recent)
            if (entry.is_string() && preferences.recentFiles.size() < mostRecentFiles)
                preferences.recentFiles.push_back(entry.get<std::string>());
    return preferences;
}

std::string preferencesText(const Preferences& preferences)
{
    const json object{
        {"windowWidth", preferences.windowWidth},
        {"windowHeight", preferences.windowHeight},
        {"panelWidth", preferences.panelWidth},
        {"interfaceScale", preferences.interfaceScale},
        {"workbenchHeight", preferences.workbenchHeight},
        {"workbenchPage", preferences.workbenchPage},
        {"samplesPerAxis", preferences.samplesPerAxis},
        {"showLightHandles", preferences.showLightHandles},
        {"tourStep", preferences.tourStep},
        {"recentFiles", preferences.recentFiles},
    };
    // A file name need not be UTF-8; what is not is replaced rather than refused.
    return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<Preferences> loadPreferences(const fs::path& folder)
{
    std::error_code ignored;
    if (folder.empty() || !fs::exists(fileIn(folder), ignored))
        return Preferences{};
    const Result<std::string> text = readWholeFile(fileIn(folder).string());
    if (!text)
        return text.error();
    return parsePreferences(text.value(), fileIn(folder).string());
}

Result<void> savePreferences(const Preferences& preferences, const fs::path& folder)
{
    if (folder.empty())
        return {};
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
        return Error{"the folder for preferences cannot be made: " + failed.message(), folder.string()};
    return writeAtomically(fileIn(folder).string(), preferencesText(preferences));
}

void remember(Preferences& preferences, const std::string& file)
{
    std::erase(preferences.recentFiles, file);
    preferences.recentFiles.push_front(file);
    if (preferences.recentFiles.size() > mostRecentFiles)
        preferences.recentFiles.resize(mostRecentFiles);
}

} // namespace reflectance::explorer
