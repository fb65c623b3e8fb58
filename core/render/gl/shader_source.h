// Puts a GLSL program text together from files, so that the compiler's messages still name the file and line.
#pragma once

#include "core/reflectance/lobe_form.h"
#include "core/reflectance/model_text.h"
#include "core/reflectance/special_form.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

struct ShaderPiece {
    std::string file; ///< for messages: "shaders/prelude.glsl"
    std::string text;
};

/// A text for the GLSL compiler. Line L of files[F] is numbered (F + 1) * linesPerFile + L: the number of the source
/// string, which GLSL has for this, is lost in Mesa's messages about anything but syntax.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;
};

/// A file under shaders/, as it travels inside the program.
[[nodiscard]] ShaderPiece shaderFile(std::string_view name);

/// "uniform float ks;" for each parameter: the text's own declarations were taken out by the parser. No initialisers,
/// since every value is uploaded. A special form declares K and ks as what it takes them for: vec3, float, or a 0.
[[nodiscard]] ShaderPiece parameterDeclarations(const ModelText& model, const SpecialForm& form = {});

/// The model's formula.
[[nodiscard]] ShaderPiece modelCode(const ModelText& model);

/// All that stands before the stage: prelude, lobe, parameters, the table's lookup where the model needs one (`hasTable`:
/// there is one), and the model.
[[nodiscard]] std::vector<ShaderPiece> modelPieces(const ModelText& model, bool hasTable,
                                                   LobeForm lobe = LobeForm::Conditioned, const SpecialForm& form = {});

inline constexpr long linesPerFile = 100'000;

/// #version 330 core, the names as #define, then the pieces.
[[nodiscard]] ShaderSource assembled(const std::vector<std::string>& defines, std::vector<ShaderPiece> pieces);

/// The first error in a compiler's log as message, file and line. Understands "0:LINE(COLUMN): error: ..." (Mesa, Intel)
/// and "0(LINE) : error ..." (NVIDIA); a log in another form becomes the message as it is.
[[nodiscard]] Error compilerError(std::string_view log, const ShaderSource& source);

} // namespace reflectance
