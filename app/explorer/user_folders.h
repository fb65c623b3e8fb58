// Where the desktop's conventions put settings, state and pictures (XDG base directories and user directories).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace reflectance::explorer {

/// $XDG_CONFIG_HOME or ~/.config, with "reflectance" below it; empty without a home.
[[nodiscard]] std::filesystem::path settingsFolder();

/// $XDG_STATE_HOME or ~/.local/state, with "reflectance" below it; empty without a home.
[[nodiscard]] std::filesystem::path stateFolder();

/// Linked shader programs from one start to the next: $XDG_CACHE_HOME or ~/.cache, with "reflectance/programs" below it;
/// empty without a home.
[[nodiscard]] std::filesystem::path programsFolder();

/// Which renderer is sooner done, as measured: a file beside that folder; empty without a home.
[[nodiscard]] std::filesystem::path backendsFile();

/// The user's pictures: XDG_PICTURES_DIR of user-dirs.dirs, else ~/Pictures if it is there, else home, else here.
[[nodiscard]] std::filesystem::path picturesFolder();

/// The value of XDG_PICTURES_DIR in the text of a user-dirs.dirs, with $HOME replaced; empty if it is not given.
[[nodiscard]] std::filesystem::path picturesFolderIn(std::string_view userDirs, const std::string& home);

/// folder/reflectance-MESH-MODEL-N.ENDING with the first N >= 1 that is still free.
[[nodiscard]] std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& mesh,
                                             const std::string& model, const std::string& ending);

} // namespace reflectance::explorer
