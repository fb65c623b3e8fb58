// A part of a picture alone: one term of the formula, one light, or what K has beside its diagonal.
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// What can be seen of the scene alone: the terms of a formula that has several ("diffuse", "specular", else "term 1" and so
/// on), of A's surface and then of B's; "offdiagonal" where one of them has a K with anything beside its diagonal; "light:1" and
/// so on.
[[nodiscard]] std::vector<std::string> termsAlone(const Scene& scene);

/// The scene with that alone. A surface that lacks the term is black; one whose formula is that term stays as it is. With
/// "offdiagonal" K, in the scene's own convention, is 0 on its diagonal and nothing else of the surface is left: channels may be
/// negative. With a light the other lights are off and the surroundings dark. The error names what there is.
[[nodiscard]] Result<Scene> onlyTerm(Scene scene, std::string_view term);

} // namespace reflectance
