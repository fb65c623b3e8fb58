#include "core/render/pictures/picture_waterfall.h"

#include "core/render/cpu/cpu_renderer.h"
#include "core/sensor/stages.h"

namespace reflectance {

std::vector<WaterfallPicture> picturesOfSensor(const Image& exact, const Image& rendered, const Sensor& sensor)
{
    Sensor plain = sensor;
    plain.view = {}; // false colours and marks are no light
    return {{"exact", exposedLight(exact, plain)},
            {"precision", exposedLight(rendered, plain)},
            {"sensor", sensedLight(rendered, plain)},
            {"encoding", decodedLight(develop(rendered, plain), plain)}};
}

std::vector<WaterfallPicture> picturesToTruth(const Scene& scene, const Scene& truth, const RenderSettings& settings,
                                              const Image& rendered, Progress* progress)
{
    const auto shaded = [&](const ViewSamples& samples, const Surface& surface) {
        Scene shown = scene;
        shown.surface = surface;
        return shadeSamples(samples, shown, Precision::Double, progress);
    };
    const ViewSamples own = sampleView(*makeRayScene(scene.mesh, settings), scene.camera, settings, progress);
    const bool sameMesh = truth.mesh == scene.mesh;
    const Image ideal =
        sameMesh
            ? shaded(own, truth.surface)
            : shaded(sampleView(*makeRayScene(truth.mesh, settings), scene.camera, settings, progress), truth.surface);
    const Image onOwnMesh = sameMesh ? ideal : shaded(own, truth.surface);
    std::vector<WaterfallPicture> pictures{{"truth", exposedLight(ideal, scene.sensor)},
                                           {"geometry", exposedLight(onOwnMesh, scene.sensor)}};
    std::vector<WaterfallPicture> rest = picturesOfSensor(shaded(own, scene.surface), rendered, scene.sensor);
    rest.front().step = "model";
    for (WaterfallPicture& picture : rest)
        pictures.push_back(std::move(picture));
    return pictures;
}

} // namespace reflectance
