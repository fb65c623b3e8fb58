// A study: a base scene and axes along which it changes. Its cells are all combinations, the last axis fastest.
#pragma once

#include "core/base/result.h"
#include "core/render/settings.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// By what a cell is rendered. Vertex is double at the mesh's vertices, interpolated over its triangles.
enum class CellRenderer { Double, Float, Simd, Glsl, Vertex };

/// What an axis changes: a place in the scene file, or how the scene is looked at.
enum class AxisKind { Scene, View, Size, Samples, Renderer };

struct StudyAxis {
    std::string name; ///< its column
    AxisKind kind = AxisKind::Scene;
    std::string pointer = {};             ///< of the scene file ("/surface/model"), for AxisKind::Scene
    std::vector<std::string> values = {}; ///< as JSON texts
    std::vector<std::string> labels = {}; ///< what the column says; as many as values
};

struct Study {
    std::string scene;  ///< the base scene as JSON text, paths relative to `folder`
    std::string folder; ///< of the study file
    RenderSettings settings{256, 256, 2};
    CellRenderer renderer = CellRenderer::Simd;
    std::vector<StudyAxis> axes;
};

/// Everything that one cell's picture depends on.
struct Cell {
    std::uint64_t index = 0;
    std::vector<std::string> labels = {};            ///< of the axes that have a column
    std::string scene = {};                          ///< JSON text
    std::optional<std::array<double, 2>> orbit = {}; ///< azimuth and elevation in degrees
    RenderSettings settings = {};
    CellRenderer renderer = CellRenderer::Simd;
};

/// More cells than this cannot be numbered in every tool that reads the figures.
inline constexpr std::uint64_t mostCells = 1'000'000'000'000'000;

/// Reads a study file; one sentence for what is wrong, contradictory or empty in it. What only some cells get wrong, such as a
/// value out of a parameter's range, is theirs to report.
[[nodiscard]] Result<Study> loadStudy(const std::string& path);
[[nodiscard]] Result<Study> parseStudy(std::string_view text, const std::string& file, const std::string& folder);

/// Within 1 .. mostCells, as loadStudy made sure.
[[nodiscard]] std::uint64_t cellCount(const Study& study);

/// `index` is below cellCount().
[[nodiscard]] Cell cellAt(const Study& study, std::uint64_t index);

[[nodiscard]] std::string_view nameOf(CellRenderer renderer);

/// Whether the axis has a column of its own; size, samples and renderer stand in every line anyway.
[[nodiscard]] bool hasColumn(const StudyAxis& axis);

} // namespace reflectance
