// How different two colours look: CIELAB under D65 and dE2000.
#pragma once

#include "core/math/vec.h"

namespace reflectance {

/// CIE 1976 L*a*b*.
struct Lab {
    double L = 0.0, a = 0.0, b = 0.0;
};

/// Relative to a white XYZ (CIE 15:2004).
[[nodiscard]] Lab labOf(const Vec3d& XYZ, const Vec3d& white);

/// Linear Rec. 709 to CIE XYZ (IEC 61966-2-1); white (1, 1, 1) has Y = 1.
[[nodiscard]] Vec3d xyzOf(const Vec3d& linearRgb);

/// Of linear Rec. 709 as a display shows it: channels are kept within 0 .. 1, NaN counts as 0. White is (100, 0, 0).
[[nodiscard]] Lab labOfDisplayed(const float* linearRgb);

/// CIEDE2000 with kL = kC = kH = 1 (Sharma, Wu & Dalal, Color Research & Application 30(1), 2005). About 1 is the
/// smallest difference that an eye sees side by side.
[[nodiscard]] double deltaE2000(const Lab& one, const Lab& other);

} // namespace reflectance
