// Shades a view's samples at fewer places than there are samples.
#pragma once

#include "core/render/cpu/cpu_renderer.h"
#include "core/render/place.h"

#include <memory>

namespace reflectance {

/// A view with the places at which it is shaded: made once, shaded many times.
struct PlacedView {
    Place place = Place::Sample;
    std::shared_ptr<const ViewSamples> samples;
    ViewSamples places;                  ///< each as the only sample of a pixel; none for Sample
    std::vector<std::uint32_t> placesOf; ///< of each sample: three for Vertex, else one
    std::vector<float> weights;          ///< of these, for Vertex

    [[nodiscard]] std::size_t shadings() const; ///< evaluations of the model per light
    [[nodiscard]] std::size_t bytes() const;    ///< kept between two shadings
};

[[nodiscard]] PlacedView placedView(std::shared_ptr<const ViewSamples> samples, const Mesh& mesh, Place place);

/// The picture, in double, float or SIMD (not Glsl). The scene's mesh is the one that was seen.
[[nodiscard]] Image shadePlaces(const PlacedView& view, const Scene& scene, const Arithmetic& arithmetic);

} // namespace reflectance
