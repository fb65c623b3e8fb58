// The way from the truth to the picture that is saved, one cause after the other: geometry, model, precision, sensor, encoding.
#pragma once

#include "core/image/waterfall.h"
#include "core/render/progress.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"

namespace reflectance {

/// Linear pictures, times the sensor's gain, in the order of the light:
///   truth      mesh and surface of `truth`, in double
///   geometry   the scene's mesh, on which truth's surface is shaded
///   model      the scene's surface
///   precision  `rendered`: what the renderer in question made of the scene
///   sensor     vignetting, noise, full well, balance and response
///   encoding   encoding, quantisation and the file, decoded again
/// Camera, lights, surroundings and sensor are those of the scene throughout. Where `truth` has the scene's own mesh or surface, that
/// step changes nothing.
[[nodiscard]] std::vector<WaterfallPicture> picturesToTruth(const Scene& scene, const Scene& truth,
                                                            const RenderSettings& settings, const Image& rendered,
                                                            Progress* progress = nullptr);

/// The last three of them, from what was rendered and what it should have been.
[[nodiscard]] std::vector<WaterfallPicture> picturesOfSensor(const Image& exact, const Image& rendered,
                                                             const Sensor& sensor);

} // namespace reflectance
