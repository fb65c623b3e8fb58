// Preferences between sessions, in settingsFolder()/preferences.json.
#pragma once

#include "app/explorer/state.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace reflectance::explorer {

/// Values out of range are brought into it and unknown keys ignored, so that older and newer programs share the file.
/// Text that is no JSON object is an error.
[[nodiscard]] Result<Preferences> parsePreferences(std::string_view text, const std::string& file);
[[nodiscard]] std::string preferencesText(const Preferences& preferences);

/// The defaults where there is no file yet.
[[nodiscard]] Result<Preferences> loadPreferences(const std::filesystem::path& folder);

/// Makes the folder where it is missing; the file is written whole or not at all.
[[nodiscard]] Result<void> savePreferences(const Preferences& preferences, const std::filesystem::path& folder);

/// Puts a file on top of the recent ones: each once, at most ten.
void remember(Preferences& preferences, const std::string& file);

} // namespace reflectance::explorer
