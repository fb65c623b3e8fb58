// Texts that a picture carries beside its pixels: a PNG in iTXt chunks, an OpenEXR file in string attributes.
#pragma once

#include <string>
#include <vector>

namespace reflectance {

struct Note {
    std::string key;  ///< 1 .. 79 letters of ASCII
    std::string text; ///< UTF-8

    friend bool operator==(const Note&, const Note&) = default;
};
using Notes = std::vector<Note>;

/// The text under a key; null where there is none.
[[nodiscard]] inline const std::string* findNote(const Notes& notes, const std::string& key)
{
    for (const Note& note : notes)
        if (note.key == key)
            return &note.text;
    return nullptr;
}

} // namespace reflectance
