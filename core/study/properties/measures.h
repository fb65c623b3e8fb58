// One function per property: how far a model is from having it, and where it is furthest. What each asks, its method and
// its tolerance stand in the table in check.cpp.
#pragma once

#include "core/study/properties/ask.h"

namespace reflectance::properties {

[[nodiscard]] Finding measureFiniteness(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureNegativity(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureUnlit(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureReciprocity(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureRotation(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureSuperposition(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureScaling(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureColours(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureAlbedo(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureFurnace(const Model& model, const Effort& effort);
[[nodiscard]] Finding measureLimits(const Model& model, const Effort& effort);

} // namespace reflectance::properties
