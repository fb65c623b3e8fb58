// The list of lights: switch, colour, name, solo, remove; and adding one.
#pragma once

#include "app/explorer/state.h"

namespace reflectance::explorer {

void drawLightList(ExplorerState& state);

/// A new light beside the others, selected. Its name is new too.
void addLight(ExplorerState& state, LightKind kind);

/// Takes a light away; selection and solo stay with the lights they were on.
void removeLight(ExplorerState& state, int index);

/// The light's tint as the screen shows it.
[[nodiscard]] unsigned int swatchColor(const Light& light);

} // namespace reflectance::explorer
