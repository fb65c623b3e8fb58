#include "app/cli/matrix_object.h"

#include "app/cli/long_work.h"

namespace reflectance::cli {

Result<std::vector<ObjectPrices>> pricesOnObject(const Scene& scene, const RenderSettings& settings,
                                                 const ColorSystem& system, const JudgedSurface& surface,
                                                 const std::vector<JudgedLight>& lights)
{
    const LongWork work;
    const ViewSamples samples = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings);
    std::vector<const JudgedLight*> spectra{nullptr};
    for (const JudgedLight& light : lights)
        if (!light.inSpan)
            spectra.push_back(&light);
    std::vector<ObjectPrices> all;
    for (const JudgedLight* spectrum : spectra) {
        const auto spectral = spectralScene(scene, system, surface, spectrum);
        if (!spectral)
            return spectral.error();
        all.push_back({spectrum ? spectrum->name : "as in the scene",
                       pricesOnPicture(samples, *spectral, system, surface,
                                       spectrum ? spectrum->white : system.W * Vec3d(1.0), &LongWork::progress())});
        if (LongWork::wasStopped())
            return Error{"stopped before every light had been judged"};
    }
    return all;
}

} // namespace reflectance::cli
