// Uploads a model's parameter values by name: a loop over its parameter table.
#pragma once

#include "core/reflectance/model_text.h"
#include "core/render/gl/gl_program.h"

#include <span>

namespace reflectance {

/// `values` is the model's flat list; each number is rounded once to float. The program must be in use.
void uploadParameters(const GlProgram& program, const ModelText& model, std::span<const double> values,
                      const SpecialForm& form = {});

/// The table of the model's n, for LobeForm::Table.
void uploadLobeTable(const GlProgram& program, const ModelText& model, std::span<const double> values);

} // namespace reflectance
