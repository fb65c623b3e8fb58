// Everything a picture depends on, as one value: copy it, compare it, save it.
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/illumination/environment.h"
#include "core/illumination/light.h"
#include "core/reflectance/catalogue.h"
#include "core/scene/measured_table.h"
#include "core/scene/pin.h"
#include "core/sensor/sensor.h"
#include "core/spectra/convention.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reflectance {

/// The reflectance model in use. Values stay when the model changes, so that two models share what they both know.
struct Surface {
    std::string model = "hybrid"; ///< id in the catalogue
    ParameterValues values;
    Convention convention = Convention::Sensor; ///< of K, and of the lights' intensities
    /// Primary convention: what sensor i (row) sees of primary j on a perfect white, row by row; not singular.
    std::array<double, 9> W{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    std::string tableFile = {};                      ///< where the table came from; empty without one
    std::shared_ptr<const MeasuredTable> table = {}; ///< what the model `table` looks up
    bool showHoles = false;                          ///< stripes where the table was not measured, instead of black
    std::string modelFile = {};                      ///< where `own` came from; empty without one
    std::shared_ptr<const Model> own = {};           ///< the user's own model, in use while `model` is its id
    std::vector<std::string> rungs = {};             ///< how its picture is made, see rung_list.h; empty: as all others

    friend bool operator==(const Surface&, const Surface&) = default;
};

/// A surface that a scene keeps under a name, to be chosen for A or B.
struct KeptSurface {
    std::string name; ///< of its own within a scene
    Surface surface;

    friend bool operator==(const KeptSurface&, const KeptSurface&) = default;
};

enum class BackgroundKind { Plain, Environment };

/// What is seen beside the object.
struct Background {
    BackgroundKind kind = BackgroundKind::Plain;
    Vec3d color{0.028, 0.030, 0.034}; ///< linear radiance

    friend bool operator==(const Background&, const Background&) = default;
};

struct Scene {
    std::string meshFile;          ///< where the mesh came from; "mug" and the like name an embedded one
    bool recomputeNormals = false; ///< smooth normals even where the file gives some (faceted files look round)
    std::shared_ptr<const Mesh> mesh;
    Camera camera;
    std::vector<Light> lights;
    Environment environment;
    Background background;
    Surface surface;              ///< A, where two variants are compared
    std::optional<Surface> other; ///< B; everything else A and B share
    Sensor sensor;
    std::vector<KeptSurface> variants = {}; ///< kept beside A and B; no picture depends on them
    std::vector<Pin> pins = {};             ///< where the probe looks; no picture depends on them
};

/// The clay mug under two lights, as the explorer opens it. The mesh is embedded in the program.
[[nodiscard]] Scene defaultScene();

/// The surface's model, its own or one of the catalogue; the error names the nearest id.
[[nodiscard]] Result<const Model*> findModelOf(const Surface& surface);

/// Reads an own model and puts it to use. On an error the surface keeps what it has.
[[nodiscard]] Result<void> readModelOf(Surface& surface, const std::string& path);

/// The surface's model; an id that nothing has is taken for the first. An own model lives as long as the surface.
[[nodiscard]] const Model& modelOf(const Surface& surface);

/// The scene with B in A's place; as it is where there is no B.
[[nodiscard]] Scene variantB(Scene scene);

/// The scene's model; its id has been checked when it was set.
[[nodiscard]] const Model& modelOf(const Scene& scene);

/// The flat parameter values of the scene's model, K in the sensor convention.
[[nodiscard]] std::vector<double> valuesOf(const Scene& scene);

/// Sets "name=1 2 3" on the surface's model; "file=PATH" reads a measured table. On an error the surface stays as it was.
[[nodiscard]] Result<void> setOnSurface(std::string_view assignment, Surface& surface);

/// Reads a measured table for the surface. On an error the surface keeps the one it has.
[[nodiscard]] Result<void> readTableOf(Surface& surface, const std::string& path);

/// Whether the surface has what its model needs: lists that agree with their choice, a table to look up.
[[nodiscard]] Result<void> checkSurface(const Surface& surface);

/// The lights that are on, as the sensor sees them on a perfect white: with them, ks I is ks W I, and every renderer knows
/// the sensor convention only.
[[nodiscard]] std::vector<Light> shiningLights(const Scene& scene);

/// Reads scene.meshFile (a stock mesh of the program by name, or any mesh file by path) into scene.mesh, with the
/// normals that the scene asks for. On an error the scene keeps its mesh.
[[nodiscard]] Result<void> readMeshOf(Scene& scene);

} // namespace reflectance
