#include "core/study/extremes/sweep.h"

#include "core/study/extremes/bench.h"
#include "core/study/extremes/directions.h"
#include "core/study/extremes/textbook.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reflectance {
namespace {

constexpr std::size_t orientations = 24;

/// A question whose answer is known from its angles.
struct Sample {
    Question question;
    double truth;
};

struct Sweep {
    std::string swept;
    std::vector<double> points; ///< from harmless to extreme
    std::function<std::vector<Sample>(const std::string& model, double point)> samples;
};

/// 10^(k/4) from one power of ten to another, upwards or downwards.
std::vector<double> powersOfTen(int from, int to)
{
    std::vector<double> points;
    const int step = from < to ? 1 : -1;
    for (int k = 4 * from; k != 4 * to + step; k += step)
        points.push_back(std::pow(10.0, k / 4.0));
    return points;
}

/// A model reduced to its lobe of height 1, seen `angle` off the peak from many sides.
std::vector<Sample> offThePeak(const std::string& model, double n, double angle)
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < orientations; ++i) {
        Question question{model, {{"ks", {1.0}}, {"n", {n}}, {"K", std::vector<double>(9, 0.0)}}};
        const auto azimuth = static_cast<double>(i);
        question.N = spread(i, orientations);
        question.L = tilted(question.N, 0.2 + 0.03 * azimuth, azimuth);
        const Vec3d R = tilted(question.N, 0.2 + 0.03 * azimuth, azimuth + std::numbers::pi);
        question.V = tilted(R, angle, 2.0 * azimuth);
        samples.push_back({question, powerOfCosine(angle, n)});
    }
    return samples;
}

std::vector<Sample> atHalfThePeak(const std::string& model, double n)
{
    return offThePeak(model, n, angleOfVersine(-std::expm1(-std::numbers::ln2 / n)));
}

std::vector<Sample> atThePeak(const std::string& model, double n)
{
    return offThePeak(model, n, 0.0);
}

/// Light just above the horizon of a white matte surface.
std::vector<Sample> grazing(const std::string& model, double angle)
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < orientations; ++i) {
        Question question{model, {{"kd", {1.0}}, {"K", {1, 0, 0, 0, 1, 0, 0, 0, 1}}}};
        question.N = spread(i, orientations);
        const Vec3d edge = tilted(question.N, 0.5 * std::numbers::pi, static_cast<double>(i));
        question.L = std::cos(angle) * edge + std::sin(angle) * question.N;
        question.V = question.N;
        samples.push_back({question, std::sin(angle)});
    }
    return samples;
}

/// Rough clay, light and viewer this far above the horizon, side by side: A g + B with sigma^2 = 0.36 and tan(beta) = 1/g.
std::vector<Sample> bothGrazing(const std::string& model, double angle)
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < orientations; ++i) {
        Question question{model, {{"rho", {1.0, 1.0, 1.0}}, {"sigma", {0.6}}}};
        question.N = spread(i, orientations);
        const Vec3d edge = tilted(question.N, 0.5 * std::numbers::pi, static_cast<double>(i));
        question.L = question.V = std::cos(angle) * edge + std::sin(angle) * question.N;
        samples.push_back({question, (1.0 - 0.18 / 0.69) * std::sin(angle) + 0.36 * std::cos(angle) * std::cos(angle)});
    }
    return samples;
}

/// The peak of GGX, where H = N and f0 = 1: 1 / (4 alpha^2 sqrt(alpha^2 + (1 - alpha^2) cos^2)).
std::vector<Sample> facetPeak(const std::string& model, double alpha)
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < orientations; ++i) {
        Question question{model, {{"alpha", {alpha}}, {"f0", {1.0, 1.0, 1.0}}}};
        const auto azimuth = static_cast<double>(i);
        const double angle = 0.2 + 0.03 * azimuth;
        question.N = spread(i, orientations);
        question.L = tilted(question.N, angle, azimuth);
        question.V = tilted(question.N, angle, azimuth + std::numbers::pi);
        const double square = alpha * alpha;
        const double cosine = std::cos(angle);
        samples.push_back({question, 0.25 / (square * std::sqrt(square + (1.0 - square) * cosine * cosine))});
    }
    return samples;
}

/// A light's disc of this radius in a mirror: seen a tenth inside its rim, not seen a tenth outside.
std::vector<Sample> smallDisc(const std::string& model, double radius)
{
    std::vector<Sample> samples;
    for (const double share : {0.9, 1.1})
        for (Sample& sample : offThePeak(model, 1.0, share * radius)) {
            sample.question.parameters = {{"reflectance", {1.0}}};
            sample.question.radius = radius * 180.0 / std::numbers::pi;
            sample.truth = share < 1.0 ? 1.0 : 0.0;
            samples.push_back(sample);
        }
    return samples;
}

/// N, L and V of this length: a power of two beside it, so that scaling itself rounds nothing.
std::vector<Sample> longVectors(const std::string& model, double size)
{
    const double scale = std::ldexp(1.0, std::ilogb(size));
    std::vector<Sample> samples = model == "mirror"                       ? smallDisc(model, 0.3)
                                  : model == "phong" || model == "hybrid" ? offThePeak(model, 2.0, 0.5)
                                  : model == "ggx"                        ? facetPeak(model, 0.5)
                                  : model == "oren_nayar"                 ? bothGrazing(model, 0.8)
                                                                          : grazing(model, 0.8);
    for (Sample& sample : samples)
        for (Vec3d* v : {&sample.question.N, &sample.question.L, &sample.question.V})
            *v = scale * *v;
    return samples;
}

std::vector<Sweep> sweepsOf(const std::string& model)
{
    std::vector<Sweep> sweeps;
    if (model == "phong" || model == "hybrid")
        sweeps = {{"n at the peak", powersOfTen(0, 7), atThePeak},
                  {"n at half the peak", powersOfTen(0, 7), atHalfThePeak}};
    else if (model == "mirror")
        sweeps = {{"radius of a light, rad", powersOfTen(-1, -15), smallDisc}};
    else if (model == "oren_nayar")
        sweeps = {{"light and viewer above the horizon, rad", powersOfTen(0, -15), bothGrazing}};
    else if (model == "ggx")
        sweeps = {{"alpha at the peak", powersOfTen(0, -4), facetPeak}};
    else
        sweeps = {{"light above the horizon, rad", powersOfTen(0, -15), grazing}};
    sweeps.push_back({"length of N, L, V, growing", powersOfTen(0, 300), longVectors});
    sweeps.push_back({"length of N, L, V, shrinking", powersOfTen(0, -300), longVectors});
    return sweeps;
}

/// The largest relative error of the answers; infinite where a 0 is missed or the answer is no number.
double worstError(Bench bench, const std::vector<Sample>& samples)
{
    std::vector<Question> questions;
    for (const Sample& sample : samples)
        questions.push_back(sample.question);
    const std::vector<Vec3d> answers = bench.ask(questions);
    double worst = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double error = largestOf(answers[i] - Vec3d(samples[i].truth));
        const double relative = error == 0.0 ? 0.0 : error / samples[i].truth;
        worst = worse(worst, relative);
    }
    return worst;
}

std::optional<double> firstLoss(const Bench& bench, const std::string& model, const Sweep& sweep)
{
    const double allowed = unitsOfThreeDigits * (bench.isDouble() ? 0x1p-53 : 0x1p-24);
    for (const double point : sweep.points)
        if (!(worstError(bench, sweep.samples(model, point)) <= allowed))
            return point;
    return std::nullopt;
}

} // namespace

std::vector<SweepTask> sweepTasks(const Instruments& instruments)
{
    std::vector<SweepTask> tasks;
    for (const Model& model : *instruments.models) {
        if (!hasTextbookForm(model))
            continue;
        for (std::size_t sweep = 0; sweep < sweepsOf(model.id()).size(); ++sweep)
            for (const Precision precision : {Precision::Double, Precision::Float, Precision::Simd, Precision::Glsl})
                if (precision != Precision::Glsl || instruments.whyNoGlsl.empty())
                    tasks.push_back({model.id(), sweep, precision});
    }
    return tasks;
}

SweepRow sweepRow(const Instruments& instruments, const SweepTask& task)
{
    const Instruments textbook = textbookInstruments(instruments);
    const Sweep sweep = sweepsOf(task.model).at(task.sweep);
    return {task.model,
            sweep.swept,
            std::string(nameOf(task.precision)),
            sweep.points.back(),
            firstLoss(Bench(textbook, task.precision), task.model, sweep),
            firstLoss(Bench(instruments, task.precision), task.model, sweep)};
}

std::vector<SweepRow> sweepExtremes(const Instruments& instruments)
{
    std::vector<SweepRow> rows;
    for (const SweepTask& task : sweepTasks(instruments))
        rows.push_back(sweepRow(instruments, task));
    return rows;
}

} // namespace reflectance
