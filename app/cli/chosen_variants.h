// `render --variant NAME`, `--a NAME`, `--b NAME`: surfaces that the scene keeps under names.
#pragma once

#include "app/cli/render_options.h"

namespace reflectance::cli {

/// Puts the named variants in the places of A and B. A --variant that is no way of showing A and B is a name: that surface is
/// shown, as A.
[[nodiscard]] Result<void> chooseVariants(RenderOptions& options, Scene& scene);

} // namespace reflectance::cli
