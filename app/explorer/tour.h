// The guided tour: twelve steps through the lecture. A step is one file of the folder tour/, which travels inside the
// program: a scene, a few sentences, something to do, a question to answer before its answer is shown, and claims that
// are measured.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// One number of a model in the plane of incidence: light at theta_i, viewer at theta_r on the mirror's side of N
/// (negative: on the light's). Per unit light intensity, cosine included.
struct Measure {
    std::string model;
    std::vector<std::string> assignments; ///< "n=40"
    double thetaI = 0.0, thetaR = 0.0;    ///< degrees
    Vec3d light{1.0, 1.0, 1.0};
    double radius = 0.0;    ///< of the light, degrees
    int channel = 1;        ///< 0 .. 2: red, green, blue
    int precision = 0;      ///< 0 .. 2: double, float, simd
    bool fromTable = false; ///< of the step's table, not of the formula
    bool asCode = false;    ///< after the sensor: 0 .. 255
    double exposure = 0.0;  ///< EV; with asCode
};

/// A sentence that can be checked: the measure, or its ratio to another one, lies within low .. high.
struct Claim {
    std::string says;
    Measure measure;
    std::optional<Measure> against;
    double low = 0.0, high = 0.0;
};

struct TourStep {
    std::string title;
    std::vector<std::string> text; ///< paragraphs
    std::string task;
    std::string question;
    std::vector<std::string> choices;
    int right = 1; ///< from 1
    std::string answer;
    Scene scene; ///< with B where two surfaces are compared
    std::vector<Claim> claims;
    std::shared_ptr<const MeasuredTable> table; ///< B's, where the step is about one
};

[[nodiscard]] int tourLength();

/// From 1. A step that cannot be read is a fault of the program; tests read them all.
[[nodiscard]] Result<TourStep> tourStep(int number);
[[nodiscard]] Result<TourStep> parseTourStep(std::string_view text, const std::string& file);

/// Measures a claim anew. The Error says what in it cannot be measured.
[[nodiscard]] Result<double> measured(const Claim& claim, const TourStep& step);
[[nodiscard]] bool holds(const Claim& claim, double value);

} // namespace reflectance::explorer
