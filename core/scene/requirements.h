// What a scene requires of a renderer, and what it does not: model only what the scene requires.
#pragma once

#include "core/reflectance/arithmetic.h"
#include "core/reflectance/required_model.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace reflectance {

/// Two scenes with equal requirements run the same shader.
struct Requirements {
    std::string model;                ///< the one that is run: see requiredSurface
    std::shared_ptr<const Model> own; ///< the model, where it is none of the catalogue
    SpecialForm form;
    bool directionalLights = false;
    bool pointLights = false;
    bool environment = false;    ///< the model looks at it and it is not black
    bool environmentMap = false; ///< the environment (seen by the model or as background) is a picture
    bool environmentBackground = false;
    bool table = false;                    ///< the model looks one up, and there is one
    bool holes = false;                    ///< of the table, to be shown
    bool positions = true;                 ///< where the samples lie: for V, for point lights, for holes
    LobeForm lobe = LobeForm::Conditioned; ///< conditioned for a model that calls none

    friend bool operator==(const Requirements&, const Requirements&) = default;

    /// Unique text for caches: "hybrid+directional"; an own model stands there with its whole text.
    [[nodiscard]] std::string key() const;
    [[nodiscard]] const Model& modelUsed() const;
};

/// The scene's model without its terms that are 0; as it is where the arithmetic is not specialised.
[[nodiscard]] RequiredModel requiredSurface(const Scene& scene, const Arithmetic& arithmetic = {});

[[nodiscard]] Requirements requirementsOf(const Scene& scene, const Arithmetic& arithmetic = {});

/// Sentences on what the picture leaves out and why: "environment: hybrid ignores it", "light 'key' has no extent, so
/// a mirror shows nothing of it".
[[nodiscard]] std::vector<std::string> leftOut(const Scene& scene);

} // namespace reflectance
