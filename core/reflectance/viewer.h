// Whether a model's text asks where it is looked at from: one that does not needs neither V nor what V is made of.
#pragma once

#include "core/reflectance/model_text.h"

namespace reflectance {

/// Whether the third parameter of `shade` occurs anywhere but in its list of parameters. True where that cannot be told.
[[nodiscard]] bool looksAtViewer(const ModelText& model);

} // namespace reflectance
