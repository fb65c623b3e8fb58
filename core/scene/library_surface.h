// A surface of the library, in a scene.
#pragma once

#include "core/scene/scene.h"
#include "core/surfaces/library.h"

namespace reflectance {

/// Takes the model and the values of a library surface, in the sensor convention; what other models keep stays.
void applySurface(const LibrarySurface& from, Surface& surface);

} // namespace reflectance
