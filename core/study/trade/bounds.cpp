#include "core/study/trade/bounds.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

namespace reflectance {
namespace {

/// The numbers of a parameter of the scene's model.
class Values {
public:
    explicit Values(const Scene& scene) : text_(modelOf(scene).text), flat_(valuesOf(scene)) {}

    [[nodiscard]] std::span<const double> of(std::string_view name) const
    {
        const Parameter* parameter = text_.find(name);
        return parameter ? std::span(flat_).subspan(parameter->offset, parameter->size) : std::span<const double>();
    }
    [[nodiscard]] double number(std::string_view name) const { return of(name)[0]; }
    /// max over the channels of the colour times I.
    [[nodiscard]] double color(std::string_view name, const Vec3d& I) const
    {
        const auto c = of(name);
        return std::max({std::fabs(c[0]) * I.x, std::fabs(c[1]) * I.y, std::fabs(c[2]) * I.z});
    }
    [[nodiscard]] double matrix(std::string_view name, const Vec3d& I) const
    {
        std::array<double, 9> M{};
        std::ranges::copy(of(name), M.begin());
        return largestOf(M, I);
    }

private:
    const ModelText& text_;
    std::vector<double> flat_;
};

double orenNayarPeak(double sigma)
{
    const double variance = std::min(sigma, 1e9) * std::min(sigma, 1e9);
    return 1.0 - 0.5 * variance / (variance + 0.33) + 0.45 * variance / (variance + 0.09);
}

} // namespace

double largestOf(const std::array<double, 9>& M, const Vec3d& I)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < 9; i += 3)
        largest = std::max(largest, std::fabs(M[i]) * I.x + std::fabs(M[i + 1]) * I.y + std::fabs(M[i + 2]) * I.z);
    return largest;
}

std::optional<Vec3d> mostArriving(const Light& light)
{
    const Vec3d I(std::fabs(light.intensity.x), std::fabs(light.intensity.y), std::fabs(light.intensity.z));
    if (light.kind == LightKind::Directional)
        return I;
    const double nearest = length(light.position) - 1.0;
    if (!(nearest > 0.0))
        return std::nullopt;
    return I / (nearest * nearest);
}

std::optional<Vec3d> mostArriving(const Scene& scene)
{
    Vec3d sum;
    for (const Light& light : shiningLights(scene)) {
        const auto most = mostArriving(light);
        if (!most)
            return std::nullopt;
        sum += *most;
    }
    return sum;
}

std::optional<double> largestRadiance(const Scene& scene, const Vec3d& I)
{
    const Values values(scene);
    const std::string& model = modelOf(scene).id();
    if (model == "lambert")
        return std::fabs(values.number("kd")) * std::max({I.x, I.y, I.z});
    if (model == "lambert_color")
        return values.matrix("K", I);
    if (model == "phong" || model == "blinn_phong")
        return values.color("ks", I);
    if (model == "hybrid")
        return values.matrix("K", I) + values.color("ks", I);
    if (model == "mirror")
        return std::fabs(values.number("reflectance")) * std::max({I.x, I.y, I.z});
    if (model == "oren_nayar")
        return orenNayarPeak(values.number("sigma")) * values.color("rho", I);
    return std::nullopt;
}

std::optional<double> largestRadiance(const Scene& scene)
{
    const auto I = mostArriving(scene);
    return I ? largestRadiance(scene, *I) : std::nullopt;
}

} // namespace reflectance
