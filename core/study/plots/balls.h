// Balls lit as the scene is, one for each surface: pictures of models side by side.
#pragma once

#include "core/image/image.h"
#include "core/render/progress.h"
#include "core/sensor/sensor.h"
#include "core/study/curves.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// As the viewer has it: x to the right, y up, z towards the viewer; L need not be a unit vector.
struct BallLight {
    Vec3d L{0, 0, 1}, I{1, 1, 1};
    double radius = 0.0; ///< degrees

    friend bool operator==(const BallLight&, const BallLight&) = default;
};

struct Ball {
    std::string name;
    ChartColor color = 0;
    Image picture; ///< linear; coverage 0 beside the ball
};

struct BallStrip {
    std::string title;
    int size = 0; ///< pixels a side
    std::vector<Ball> balls;
    Sensor sensor;
};

/// The unit normal at a place of a ball's picture, -1 .. 1 from its lower left; nothing beside it.
[[nodiscard]] std::optional<Vec3d> normalAt(double x, double y);

/// Seen from far away, in float lanes, 2 x 2 samples a pixel. The scene's environment is left out. A mirror sees lights of at
/// least 5 degrees. Nothing where `progress` was cancelled.
[[nodiscard]] std::optional<BallStrip> ballsOf(const std::vector<NamedSurface>& surfaces,
                                               const std::vector<BallLight>& lights, const Sensor& sensor, int size,
                                               Progress& progress);

/// 8-bit RGB of all balls side by side, rows from the top: balls.size() * size wide.
[[nodiscard]] std::vector<std::uint8_t> developedStrip(const BallStrip& strip);

/// The parameters that a wedge can be made of: numbers, and colours as grey.
[[nodiscard]] std::vector<const Parameter*> wedgeParameters(const ModelText& model);

/// The surface with one parameter at `count` values over its slider's range, evenly on the slider's own scale.
/// Names are "n = 40".
[[nodiscard]] std::vector<NamedSurface> wedgeOf(const NamedSurface& surface, const Parameter& parameter, int count);

[[nodiscard]] std::string svgOf(const BallStrip& strip, int width, int height);

/// "series,x,red,green,blue": the linear values along the middle row of each ball, x from -1 to 1.
[[nodiscard]] std::string csvOf(const BallStrip& strip);

} // namespace reflectance
