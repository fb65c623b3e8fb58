// Axes of a study as its file writes them. Internal to studies.
#pragma once

#include "core/scene/json_reader.h"
#include "core/study/sweep/study.h"

namespace reflectance {

/// The names that a study gives renderers.
inline constexpr NamedValue<CellRenderer> cellRenderers[] = {{"double", CellRenderer::Double},
                                                             {"float", CellRenderer::Float},
                                                             {"simd", CellRenderer::Simd},
                                                             {"glsl", CellRenderer::Glsl},
                                                             {"vertex", CellRenderer::Vertex}};

/// { "axis": NAME, "values": [...], "names": [...] } or { "axis": NAME, "from": a, "to": b, "steps": n, "scale": "log" }.
void readAxis(ObjectReader object, StudyAxis& axis);

/// Finds what the axis changes, and looks at its values; `base` is the base scene. A sentence if it cannot be.
[[nodiscard]] Result<void> placeAxis(const nlohmann::ordered_json& base, StudyAxis& axis);

} // namespace reflectance
