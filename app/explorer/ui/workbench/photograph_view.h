// The photograph that a model is fitted to, and the pixels that are marked in it.
#pragma once

#include "app/explorer/fit_study.h"

#include <imgui.h>

namespace reflectance::explorer {

/// Fits the picture into `size`. A click marks a pixel, a click on a mark takes it away.
void drawPhotograph(FitStudy& study, ImVec2 size);

} // namespace reflectance::explorer
