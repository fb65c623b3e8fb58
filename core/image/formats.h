// One pair of functions per picture format: bytes of a file to a linear Image, and back. For picture_file.cpp and
// tests.
// `path` only serves messages. Readers survive any bytes: an Error or an Image, within the bounds of dimensions.h.
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

/// 8 or 16 bits; grey, RGB or palette, with or without alpha (-> coverage, colours not divided by it). Code values are
/// decoded with the sRGB curve, with that of Rec. 709 where a cICP chunk says so, or with the file's own gAMA exponent where
/// that is not 1/2.2 and no sRGB chunk stands beside it.
[[nodiscard]] Result<Image> decodedPng(std::string_view bytes, const std::string& path);

/// 8-bit or 16-bit RGB with the chunks that say how it is encoded: sRGB, gAMA and cHRM; for Rec. 709 cICP (ITU-T H.273:
/// 1, 1, 0, full range), gAMA for who does not know it, and cHRM; for linear gAMA and cHRM. The notes stand before the
/// pixels, uncompressed.
[[nodiscard]] std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb, const PngColor& = {},
                                     const Notes& notes = {});
[[nodiscard]] std::string encodedPng(int width, int height, std::span<const std::uint16_t> rgb, const PngColor& = {},
                                     const Notes& notes = {});

/// Texts before the pixels, of any of the three kinds of chunk; what libpng refuses to hold (8 MB) is left out.
[[nodiscard]] Result<Notes> notesOfPng(std::string_view bytes, const std::string& path);

/// First part, any compression, half or float; R G B or Y alone; A -> coverage. The picture is the data window.
[[nodiscard]] Result<Image> decodedExr(std::string_view bytes, const std::string& path);

/// float R G B, and A where the image has coverage; ZIP compression (lossless); chromaticities of Rec. 709, white D65. The
/// notes are string attributes.
[[nodiscard]] std::string encodedExr(const Image& image, const Notes& notes = {});

/// String attributes of the first part.
[[nodiscard]] Result<Notes> notesOfExr(std::string_view bytes, const std::string& path);

/// PF (colour) and Pf (grey), both byte orders; values are multiplied by the absolute value of the file's scale.
[[nodiscard]] Result<Image> decodedPfm(std::string_view bytes, const std::string& path);

/// PF, little endian, scale 1, rows from the bottom.
[[nodiscard]] std::string encodedPfm(const Image& image);

/// Radiance RGBE, flat, old and new run lengths. A mantissa m stands for (m + 1/2) 2^(e - 136), the middle of its
/// interval (Ward, Real Pixels, Graphics Gems II, 1991); e = 0 is black. Divided by the header's EXPOSURE values.
[[nodiscard]] Result<Image> decodedHdr(std::string_view bytes, const std::string& path);

} // namespace reflectance
