#include "core/study/extremes/bench.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance {

const Model* Bench::find(std::string_view id) const
{
    const auto found =
        std::find_if(models().begin(), models().end(), [id](const Model& model) { return model.id() == id; });
    return found == models().end() ? nullptr : &*found;
}

std::vector<Vec3d> Bench::ask(const Model& model, std::span<const double> values, std::span<const Observation> rows)
{
    auto answers = instruments_.evaluate(model, values, rows, precision_);
    if (answers)
        return *std::move(answers);
    problem_ = answers.error();
    return std::vector<Vec3d>(rows.size(), Vec3d(NAN));
}

Vec3d Bench::ask(const Question& question)
{
    return ask(std::vector<Question>{question}).front();
}

std::vector<Vec3d> Bench::ask(const std::vector<Question>& questions)
{
    const Model* model = find(questions.front().model);
    if (!model) {
        problem_ = Error{"there is no model '" + questions.front().model + "'"};
        return std::vector<Vec3d>(questions.size(), Vec3d(NAN));
    }
    std::vector<Observation> rows;
    rows.reserve(questions.size());
    for (const Question& question : questions)
        rows.push_back(observationOf(question));
    return ask(*model, flatValues(model->text, questions.front().parameters), rows);
}

Image Bench::render(const Scene& scene, const RenderSettings& settings)
{
    auto picture = instruments_.render(scene, settings, precision_);
    if (picture)
        return *std::move(picture);
    problem_ = picture.error();
    return Image(settings.width, settings.height);
}

double Bench::unit() const
{
    return precision_ == Precision::Double ? 0x1p-53 : precision_ == Precision::Glsl ? 0x1p-23 : 0x1p-24;
}

double Bench::bound(double kappa) const
{
    return (precision_ == Precision::Glsl ? 64.0 : 32.0) * (kappa + 1.0) * unit();
}

Observation observationOf(const Question& question)
{
    return {question.N, question.V, {{question.L, question.I, question.radius}}};
}

double largestOf(const Vec3d& v)
{
    if (!isFinite(v))
        return NAN;
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

double worse(double a, double b)
{
    return std::isnan(a) || std::isnan(b) ? INFINITY : std::max(a, b);
}

std::string textOf(const Vec3d& v)
{
    if (v.x == v.y && v.y == v.z)
        return general(v.x, 9);
    return general(v.x, 9) + " " + general(v.y, 9) + " " + general(v.z, 9);
}

bool isFinite(const Vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Outcome within(double error, double bound, const std::string& what)
{
    // A NaN is never within.
    return {error <= bound, what + " " + general(error, 3) + " (allowed " + general(bound, 3) + ")"};
}

} // namespace reflectance
