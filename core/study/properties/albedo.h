// What share of the light a model sends on, by quadrature over the hemisphere.
#pragma once

#include "core/reflectance/catalogue.h"
#include "core/study/properties/quadrature.h"

#include <span>
#include <vector>

namespace reflectance::properties {

/// A share per sensor for light of colour (1,1,1), and how far two quadratures of different order lie apart: a bound in
/// practice of the error of the better one.
struct Share {
    Vec3d value;
    double error = 0.0;
};

/// Shares at one angle between the normal and the light (or viewer). Two families of grids are at hand: one about the
/// mirrored direction for highlights, one about the normal for matte surfaces; the one that served last is tried first.
/// The grids are kept from call to call.
class HemisphereSums {
public:
    /// `angle` in degrees, below 90.
    explicit HemisphereSums(double angle);

    /// Directional albedo: what leaves in all directions over what arrives from a light at the angle,
    /// integral of factor(L,V) N.V dV / (pi N.L). A model that sees only lights with extent gets a light of a small
    /// disc, above the horizon as a whole, which brings sin(radius)^2 of what one of the same radiance I would.
    [[nodiscard]] Share albedo(const Model& model, std::span<const double> values);

    /// What a viewer at the angle sees where radiance 1 arrives from everywhere: integral of factor(L,V) dL / pi, and the
    /// surroundings that the model looks at by itself. Equals the albedo if the model is reciprocal.
    [[nodiscard]] Share furnace(const Model& model, std::span<const double> values);

    /// What a model that looks a table up finds from now on; black before.
    void lookUpIn(const MeasuredSurface<double>& measured) { measured_ = measured; }

    [[nodiscard]] double angle() const { return angle_; }

private:
    using Sum = Vec3d (HemisphereSums::*)(const Model&, std::span<const double>,
                                          const std::vector<WeightedDirection>&) const;

    [[nodiscard]] Share refined(Sum sum, const Model& model, std::span<const double> values);
    [[nodiscard]] Share refinedOn(bool upright, Sum sum, const Model& model, std::span<const double> values);
    [[nodiscard]] Vec3d albedoSum(const Model& model, std::span<const double> values,
                                  const std::vector<WeightedDirection>& grid) const;
    [[nodiscard]] Vec3d furnaceSum(const Model& model, std::span<const double> values,
                                   const std::vector<WeightedDirection>& grid) const;

    MeasuredSurface<double> measured_;
    double angle_;
    double discRadius_; ///< degrees
    Vec3d fixed_;       ///< the light for the albedo, the viewer for the furnace
    using Grids = std::vector<std::vector<WeightedDirection>>;
    Grids leaning_, upright_; ///< in the order of their orders
    bool uprightFirst_ = false;
};

} // namespace reflectance::properties
