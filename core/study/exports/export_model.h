// A model with its parameters as a file that other programs use: a GLSL function, a C++ header, a table. Each carries test
// vectors with what double gives and a tolerance, and the code checks itself by them.
#pragma once

#include "core/reflectance/catalogue.h"

#include <optional>
#include <string>
#include <vector>

namespace reflectance {

enum class ExportForm { Glsl, Cpp, Csv };

struct ExportFormFacts {
    ExportForm form;
    std::string_view name;   ///< in flags: "glsl"
    std::string_view ending; ///< of its files: ".h"
    std::string_view about;
};

/// All forms, in the order of the enumeration.
[[nodiscard]] std::span<const ExportFormFacts> exportForms();

/// The form that a file's ending asks for: .glsl, .frag, .h, .hpp, .csv and the like.
[[nodiscard]] std::optional<ExportForm> formForFile(std::string_view path);

struct ExportSubject {
    const Model* model = nullptr;
    std::vector<double> values;     ///< the model's flat list
    MeasuredSurfaces measured = {}; ///< of a model that looks a table up
    std::string tableFile = {};     ///< whence that table came
};

/// The file's text. GLSL and C++ hold formulas, so a measured table is refused there, as are parameters that are not finite.
[[nodiscard]] Result<std::string> exported(const ExportSubject& subject, ExportForm form);

} // namespace reflectance
