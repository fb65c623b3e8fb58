// The parts of the sensor, each with its switch. A picture passes through them in this order; see docs/sensor.md.
#pragma once

#include "core/base/named_value.h"
#include "core/image/encoding.h"
#include "core/math/vec.h"
#include "core/sensor/response_curve.h"

#include <array>
#include <memory>
#include <string>

namespace reflectance {

/// A camera's three settings instead of a bare EV. A radiance of 1 is `white` cd/m2; with saturation-based speed
/// (ISO 12232:2006) and the usual q = 0.65 a pixel is full at 1.2 N^2 / t * 100 / S cd/m2, so
/// the gain is white t S / (120 N^2). The defaults are the sunny-16 rule: gain 1.
struct CameraExposure {
    bool on = false;
    double aperture = 16.0; ///< N, the f-number
    double shutter = 0.01;  ///< t, seconds
    double iso = 100.0;     ///< S
    double white = 30720.0; ///< cd/m2 of radiance 1; a white diffuser in full sun has about 31800

    friend bool operator==(const CameraExposure&, const CameraExposure&) = default;
};

enum class FallOff { Cos4, Polynomial };
inline constexpr NamedValue<FallOff> fallOffs[] = {{"cos4", FallOff::Cos4}, {"polynomial", FallOff::Polynomial}};

/// Light lost towards the corners. r is the distance from the middle, 1 in the corners.
struct Vignetting {
    bool on = false;
    FallOff kind = FallOff::Cos4; ///< cos^4 of the angle to the axis, or 1 + a r^2 + b r^4 + c r^6, never below 0
    double corner = 25.0;         ///< degrees between axis and corner; cos^4
    Vec3d polynomial{-0.4, 0, 0}; ///< a, b, c

    friend bool operator==(const Vignetting&, const Vignetting&) = default;
};

/// Electrons: a value x is x fullWell of them (with the camera on, x fullWell 100 / ISO). Shot noise has their number as
/// variance; both are drawn from a normal distribution, which a Poisson one resembles above some 20 electrons.
struct Noise {
    bool on = false;
    bool shot = true;
    double read = 5.0;         ///< standard deviation, electrons
    double fullWell = 20000.0; ///< electrons at value 1
    int seed = 1;              ///< of the dither, too; the same seed gives the same noise everywhere

    friend bool operator==(const Noise&, const Noise&) = default;
};

/// A pixel holds no more than this.
struct Well {
    bool on = true;
    double limit = 1.0;

    friend bool operator==(const Well&, const Well&) = default;
};

/// White balance, then a colour matrix, row by row, that acts on the balanced channels.
struct Balance {
    bool on = false;
    Vec3d gains{1, 1, 1};
    std::array<double, 9> matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};

    friend bool operator==(const Balance&, const Balance&) = default;
};

enum class ResponseKind { Gamma, Curve };
inline constexpr NamedValue<ResponseKind> responseKinds[] = {{"gamma", ResponseKind::Gamma},
                                                             {"curve", ResponseKind::Curve}};

/// Off, it is linear.
struct Response {
    bool on = false;
    ResponseKind kind = ResponseKind::Gamma;
    double gamma = 2.2; ///< x^(1 / gamma)
    std::string file = {};
    std::shared_ptr<const ResponseCurve> curve = {}; ///< of the file

    /// A curve that was read twice is one curve.
    friend bool operator==(const Response& a, const Response& b)
    {
        const bool isSameCurve = a.curve == b.curve || (a.curve && b.curve && *a.curve == *b.curve);
        return a.on == b.on && a.kind == b.kind && a.gamma == b.gamma && a.file == b.file && isSameCurve;
    }
};

inline constexpr NamedValue<EncodingKind> encodingKinds[] = {
    {"linear", EncodingKind::Linear}, {"srgb", EncodingKind::Srgb}, {"rec709", EncodingKind::Rec709}};

/// sRGB: IEC 61966-2-1. Rec. 709: the camera's curve of ITU-R BT.709-6. Off, it is linear.
struct Encoding {
    bool on = true;
    EncodingKind kind = EncodingKind::Srgb;

    friend bool operator==(const Encoding&, const Encoding&) = default;
};

/// Off, the file's 16 bits are all that rounds.
struct Quantisation {
    bool on = true;
    int bits = 8;        ///< 1 .. 16
    bool dither = false; ///< rounds up as often as the fraction says, instead of to the nearest

    friend bool operator==(const Quantisation&, const Quantisation&) = default;
};

enum class SensorViewKind { Picture, Luminance, FalseColor };
inline constexpr NamedValue<SensorViewKind> sensorViewKinds[] = {{"picture", SensorViewKind::Picture},
                                                                 {"luminance", SensorViewKind::Luminance},
                                                                 {"false-colour", SensorViewKind::FalseColor}};

/// What of it is looked at, and whether what the sensor could not show is painted.
struct SensorView {
    SensorViewKind kind = SensorViewKind::Picture;
    bool marks = false;

    friend bool operator==(const SensorView&, const SensorView&) = default;
};

} // namespace reflectance
