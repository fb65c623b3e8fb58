// What the panels remember between frames and what is no part of the scene: open folds, half-typed paths, values that a
// mode hides for a while.
#pragma once

#include "app/explorer/ui/folder.h"
#include "core/math/vec.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// How a colour matrix is edited. Each mode holds the ones before it.
enum class MatrixMode { Scalar, Diagonal, Full };

/// What a narrower mode of a colour matrix hides, so that going back restores it.
struct MatrixMemory {
    std::optional<MatrixMode> picked;           ///< none: follows from the values
    std::optional<std::array<double, 9>> wider; ///< the matrix before the last narrowing, row by row
};

/// A folder as it was when it was read; the disk is not asked again every frame.
struct Listing {
    std::filesystem::path folder;
    bool everyFile = false;
    std::vector<FolderEntry> entries;
    std::string problem; ///< one sentence where the folder could not be read
};

/// The file browser's place. It stays while the browser is closed.
struct BrowserMemory {
    std::filesystem::path folder; ///< empty before the first opening
    std::string typed;            ///< the path line: filters the list, or leads to another folder
    int selected = 0;             ///< index into the shown entries
    bool everyFile = false;       ///< also endings that the program does not read
    bool wantsFocus = true;       ///< the path line takes the keyboard in the next frame
    std::optional<Listing> listing;
};

struct PanelMemory {
    std::map<std::string, MatrixMemory, std::less<>> matrices; ///< by parameter name
    BrowserMemory browser;
    Vec3d tint{1.0, 1.0, 1.0}; ///< colour of the edited light while its strength is 0
    int tintOf = -1;           ///< which light that is
};

} // namespace reflectance::explorer
