#include "core/scene/library_surface.h"

#include <utility>

namespace reflectance {

void applySurface(const LibrarySurface& from, Surface& surface)
{
    surface.model = from.group->model;
    surface.convention = Convention::Sensor; // published colours are what a sensor sees under white light
    surface.values = withSurface(from, std::move(surface.values));
}

} // namespace reflectance
