// Surface constants that people have published or fitted: for each surface a model, its parameters, and where they come
// from. Facts only; the measurements behind the fits are not in here.
#pragma once

#include "core/reflectance/catalogue.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// Surfaces with one model, one source and one way to read the numbers.
struct SurfaceGroup {
    std::string id;         ///< "ngan_ward"
    std::string name;       ///< "MERL fits, Ward"
    std::string model;      ///< id in the catalogue
    std::string source;     ///< author, title, year
    std::string convention; ///< formula, units and what was done to the published numbers
    std::string note;       ///< what to know before using them
};

/// A number that belongs to the surface and that its model does not read: "ambient", "rms".
struct SurfaceFact {
    std::string name, text;
};

struct LibrarySurface {
    std::string id; ///< "opengl/gold"
    std::string name;
    std::shared_ptr<const SurfaceGroup> group;
    ParameterValues values; ///< of the group's model; what is not named here has the model's default
    std::vector<SurfaceFact> facts;
};

/// All surfaces, group by group.
[[nodiscard]] const std::vector<LibrarySurface>& surfaceLibrary();

/// The groups, in the same order.
[[nodiscard]] std::vector<std::shared_ptr<const SurfaceGroup>> surfaceGroups();

/// By id, or by a name (whatever its case) or an id without its group that only one surface has. The error names the candidates.
[[nodiscard]] Result<const LibrarySurface*> findSurface(std::string_view idOrName);

/// Those in which every word occurs: in the name, the id, the group, its model, its source, its note or the facts, whatever
/// the case. `group` is a group's id or empty for all.
[[nodiscard]] std::vector<const LibrarySurface*> searchSurfaces(std::string_view words, std::string_view group = {});

/// The values that a scene has once the surface is applied: those of the surface, defaults for what it leaves open, and
/// what other models keep.
[[nodiscard]] ParameterValues withSurface(const LibrarySurface& surface, ParameterValues values);

/// A parameter's numbers for people: a diagonal matrix by its diagonal, equal channels by one number, a long list by its
/// length.
[[nodiscard]] std::string inBrief(const std::vector<double>& numbers);

/// True where the values are those that the surface gives.
[[nodiscard]] bool isSurface(const LibrarySurface& surface, const ParameterValues& values);

} // namespace reflectance
