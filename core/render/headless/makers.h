// The makers of headless contexts. Each returns a current context or a sentence on what is missing.
#pragma once

#include "core/render/headless/headless_context.h"

namespace reflectance {

[[nodiscard]] Result<std::unique_ptr<HeadlessContext>> openOsMesa();
[[nodiscard]] Result<std::unique_ptr<HeadlessContext>> openEgl();

} // namespace reflectance
