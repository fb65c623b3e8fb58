// Pictures in files: which format a name or a content asks for, and reading any of them as a linear Image.
#pragma once

#include "core/base/result.h"
#include "core/image/encoding.h"
#include "core/image/image.h"
#include "core/image/notes.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace reflectance {

enum class PictureFormat { Png, Exr, Pfm, Hdr };

/// By the name's ending (.png, .exr, .pfm; any case): the formats this program writes.
[[nodiscard]] Result<PictureFormat> outputFormat(const std::string& path);

struct Picture {
    Image image; ///< linear
    PictureFormat format = PictureFormat::Png;

    /// EXR, PFM and HDR hold linear values as they are; a PNG went through a sensor.
    [[nodiscard]] bool isLinear() const { return format != PictureFormat::Png; }
};

/// Reads PNG, OpenEXR, PFM or Radiance HDR; the content decides, not the name. Names in messages are `path`.
[[nodiscard]] Result<Picture> readPicture(const std::string& path);
[[nodiscard]] Result<Picture> decodedPicture(std::string_view bytes, const std::string& path);

/// The texts that a PNG or an OpenEXR file carries; other pictures carry none.
[[nodiscard]] Result<Notes> decodedNotes(std::string_view bytes, const std::string& path);

/// Writes linear values as .exr or .pfm, by the ending. A PFM has no place for coverage and notes.
[[nodiscard]] Result<void> writeLinear(const std::string& path, const Image& image, const Notes& notes = {});

/// Writes code values (3 per pixel, rows from the top) as PNG of 8 or 16 bits.
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb,
                                    const PngColor& color = {}, const Notes& notes = {});
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint16_t> rgb,
                                    const PngColor& color = {}, const Notes& notes = {});

} // namespace reflectance
