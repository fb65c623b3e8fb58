// Opens mesh files: OBJ, PLY, OFF and STL into a Mesh, with a report of what was found and repaired.
#pragma once

#include "core/base/result.h"
#include "core/geometry/mesh.h"
#include "core/geometry/report.h"

#include <atomic>
#include <memory>
#include <string_view>

namespace reflectance {

struct LoadOptions {
    double creaseAngleDegrees = 55.0; ///< edges that bend by more stay sharp where normals are computed: of a scan
                                      ///< no rough spot, of a six-sided prism every edge
    bool recomputeNormals = false;    ///< compute them even where the file gives some
    std::atomic<double>* progress = nullptr;   ///< 0 .. 1, for another thread to watch
    const std::atomic<bool>* cancel = nullptr; ///< set by another thread to give up; the Error then says so
};

struct LoadedMesh {
    std::shared_ptr<const Mesh> mesh;
    MeshReport report;
};

/// Reads a mesh file of any of the four formats. Never throws: a file that is too large for the memory is an Error too.
[[nodiscard]] Result<LoadedMesh> loadMesh(const std::string& path, const LoadOptions& options = {});

/// The same for bytes at hand; `name` ("meshes/mug.obj") names them in errors and gives title and extension.
[[nodiscard]] Result<LoadedMesh> readMesh(std::string_view bytes, const std::string& name,
                                          const LoadOptions& options = {});

/// The meshes that the program carries: "mug", "sphere", ...
[[nodiscard]] std::vector<std::string> stockMeshNames();

/// A stock mesh by its name, anything else as a path ("./mug" is a path).
[[nodiscard]] Result<LoadedMesh> loadStockOrFile(const std::string& nameOrPath, const LoadOptions& options = {});

} // namespace reflectance
