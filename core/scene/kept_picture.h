// What a saved picture carries: the scene that it shows, how it was made, and by which version of the program. With it the
// picture can be made again, equal to the last bit.
#pragma once

#include "core/base/result.h"
#include "core/image/notes.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace reflectance {

/// Which of two variants a picture shows, and how.
enum class VariantView { A, B, SideBySide, Wipe, Difference };

/// "A", "B", "side", "wipe", "difference".
[[nodiscard]] std::string_view nameOf(VariantView shown);

/// How a picture was made of its scene.
struct PictureRecipe {
    int width = 512, height = 512; ///< pixels of the whole picture
    int samplesPerAxis = 2;
    std::string backend = "gl";       ///< "gl" or "cpu"
    std::string precision = "glsl";   ///< "glsl", "double", "float" or "simd"
    std::string shading = "pixel";    ///< "pixel", "fragment", "once", "vertex" or "face"
    std::string lobe = "conditioned"; ///< the form of (R.V)^n
    std::string lens = "none";        ///< the arithmetic whose digits are painted: "float", "half", "simd" or "glsl"
    VariantView shown = VariantView::A;
    double divider = 0.5;  ///< Wipe: A's share of the width
    std::string term = {}; ///< seen alone, as onlyTerm has it; empty: the whole
    bool holes = false;    ///< stripes where a measured table has no value

    friend bool operator==(const PictureRecipe&, const PictureRecipe&) = default;
};

struct KeptPicture {
    Scene scene;
    PictureRecipe recipe;
    std::string program; ///< version that wrote it
};

/// The notes of a picture that is written into `folder`: the session, and the program's name for other programs. Files are
/// named from the root; where they are gone, they are looked for as they lay beside the picture.
[[nodiscard]] Notes keptNotes(const Scene& scene, const PictureRecipe& recipe, const std::string& folder);

/// Reads what keptNotes wrote. `file` serves messages, `folder` is where the picture lies now.
[[nodiscard]] Result<KeptPicture> parseKept(std::string_view text, const std::string& file, const std::string& folder);

/// Of a PNG's or an OpenEXR file's bytes; a picture that carries none is an error that says so.
[[nodiscard]] Result<KeptPicture> keptIn(std::string_view picture, const std::string& file);
[[nodiscard]] Result<KeptPicture> loadKept(const std::string& path);

/// Whether the bytes are a picture that carries a session, readable or not.
[[nodiscard]] bool carriesSession(std::string_view picture);

} // namespace reflectance
