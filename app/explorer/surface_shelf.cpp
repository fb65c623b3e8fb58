#include "app/explorer/surface_shelf.h"

#include "core/geometry/load.h"
#include "core/render/cpu/cpu_renderer.h"
#include "core/scene/library_surface.h"
#include "core/sensor/sensor.h"

namespace reflectance::explorer {
namespace {

struct Sphere {
    Camera camera;
    ViewSamples samples;
};

/// Seen from the front and filling the picture; the same samples serve every surface.
std::optional<Sphere> sampledSphere()
{
    auto loaded = loadStockOrFile("sphere", LoadOptions());
    if (!loaded)
        return std::nullopt;
    Sphere sphere;
    sphere.camera = framed(sphere.camera, 1.0);
    sphere.samples = sampleView(*makeRayScene(loaded->mesh), sphere.camera, {thumbnailSize, thumbnailSize, 2});
    return sphere;
}

} // namespace

std::optional<std::vector<Thumbnail>> makeThumbnails(const Scene& lit, const std::vector<std::string>& ids,
                                                     Progress& progress)
{
    static const std::optional<Sphere> sphere = sampledSphere();
    static properties::BudgetMeter meter; // one batch runs at a time
    std::vector<Thumbnail> made;
    Scene scene = lit;
    scene.background = Background();
    for (const std::string& id : ids) {
        const auto found = findSurface(id);
        if (progress.cancel || !sphere || !found)
            return std::nullopt;
        applySurface(**found, scene.surface);
        const Image image = shadeSamples(sphere->samples, scene, Precision::Simd, &progress);
        made.push_back({id, develop(image, scene.sensor).rgb, meter.budgetOf(modelOf(scene), valuesOf(scene))});
    }
    return made;
}

void applyFromShelf(SurfaceShelf& shelf, const LibrarySurface& from, Surface& inHand)
{
    if (!canGoBack(shelf, inHand))
        shelf.before = inHand;
    applySurface(from, inHand);
    shelf.applied = inHand;
}

bool canGoBack(const SurfaceShelf& shelf, const Surface& inHand)
{
    return shelf.before && inHand == shelf.applied;
}

void goBack(SurfaceShelf& shelf, Surface& inHand)
{
    if (canGoBack(shelf, inHand))
        inHand = *shelf.before;
    shelf.before.reset();
}

} // namespace reflectance::explorer
