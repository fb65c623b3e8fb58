// Where one hazard is put to the test in one arithmetic: asks models, builds the reasons of a verdict.
#pragma once

#include "core/study/extremes/instruments.h"

#include <optional>

namespace reflectance {

/// What a check saw.
struct Outcome {
    bool holds = false;
    std::string found;
};

/// One question: a model's value for one light.
struct Question {
    std::string model;
    ParameterValues parameters;
    Vec3d N{0, 0, 1}, L{0, 0, 1}, V{0, 0, 1};
    Vec3d I{1, 1, 1};
    double radius = 0.0; ///< of the light, degrees
};

class Bench {
public:
    Bench(const Instruments& instruments, Precision precision) : instruments_(instruments), precision_(precision) {}

    [[nodiscard]] Precision precision() const { return precision_; }
    [[nodiscard]] bool isDouble() const { return precision_ == Precision::Double; }
    [[nodiscard]] const std::vector<Model>& models() const { return *instruments_.models; }
    [[nodiscard]] const Model* find(std::string_view id) const;

    /// The answers; NaN, and the reason in problem(), where the instrument refuses.
    [[nodiscard]] std::vector<Vec3d> ask(const Model& model, std::span<const double> values,
                                         std::span<const Observation> rows);
    [[nodiscard]] Vec3d ask(const Question& question);
    /// Many questions to one model with one set of values.
    [[nodiscard]] std::vector<Vec3d> ask(const std::vector<Question>& questions);
    /// A black picture, and the reason in problem(), where the instrument refuses.
    [[nodiscard]] Image render(const Scene& scene, const RenderSettings& settings);

    /// Half a unit in the last place of 1: 2^-53, 2^-24. GLSL: 2^-23, since it leaves the rounding of divisions open.
    [[nodiscard]] double unit() const;
    /// The bound on the relative error of a value whose inputs' rounding is magnified by kappa: 32 (kappa + 1) units,
    /// GLSL 64.
    [[nodiscard]] double bound(double kappa) const;

    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

private:
    const Instruments& instruments_;
    Precision precision_;
    std::optional<Error> problem_;
};

[[nodiscard]] Observation observationOf(const Question& question);
[[nodiscard]] double largestOf(const Vec3d& v);
/// The larger of two errors; NaN is infinitely wrong (std::max would drop it).
[[nodiscard]] double worse(double a, double b);
/// "0.75 0.375 0.1875", nine digits; one number where all are equal.
[[nodiscard]] std::string textOf(const Vec3d& v);
[[nodiscard]] bool isFinite(const Vec3d& v);
/// Holds where error <= bound; found says both: "worst error 1e-9 (allowed 1e-8)".
[[nodiscard]] Outcome within(double error, double bound, const std::string& what);

} // namespace reflectance
