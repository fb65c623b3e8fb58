// `render --highlight-at`, `--edge-at`: the light that puts its highlight at a point of the picture, the width that ends it there.
#pragma once

#include "core/render/settings.h"
#include "core/scene/scene.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace reflectance::cli {

/// "X,Y" or "X,Y,LIGHT": moves that light (from 1; the first that is on) so that R.V peaks there. Returns its index.
[[nodiscard]] Result<std::size_t> putHighlight(const std::string& text, const RenderSettings& settings, Scene& scene);

/// "X,Y" or "X,Y,LIGHT": gives A's surface the width with which that light's highlight has half its height there. Returns the
/// name of the model's number that says so, and its value.
[[nodiscard]] Result<std::pair<std::string, double>> putEdge(const std::string& text, const RenderSettings& settings,
                                                             Scene& scene);

/// Where the light is now.
[[nodiscard]] nlohmann::ordered_json lightReport(const Light& light, std::size_t index);

} // namespace reflectance::cli
