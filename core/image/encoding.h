// How code values stand for light, as a picture's file has to say it.
#pragma once

namespace reflectance {

enum class EncodingKind { Linear, Srgb, Rec709 };

/// The primaries are those that Rec. 709 and sRGB share, white is D65.
struct PngColor {
    EncodingKind encoding = EncodingKind::Srgb;
    double gamma = 1.0; ///< Linear: codes are light^(1 / gamma); > 0
};

} // namespace reflectance
