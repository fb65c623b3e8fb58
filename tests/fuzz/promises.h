// What every reader promises for any bytes: a refusal is one sentence, and what is accepted can be used without a look.
#pragma once

#include "app/cli/eval_rows.h"
#include "core/geometry/load.h"
#include "core/image/image.h"
#include "core/reflectance/model_text.h"
#include "core/scene/scene.h"

#include <string>

namespace reflectance::fuzz {

// Each returns the promise that is broken in words; empty when all are kept. `bytes` is the size of what was read: no
// value may be larger than a stated multiple of it.

/// One line, printable or UTF-8, that names the file and is short enough to be read.
[[nodiscard]] std::string brokenPromise(const Error& refusal);
/// Finite positions within the unit sphere, unit normals, indices that exist, counts that agree; at most one triangle
/// per byte of the file.
[[nodiscard]] std::string brokenPromise(const LoadedMesh& loaded, std::size_t bytes);
/// As many values as pixels; at most 16384 pixels per byte of the file, what the best compression can hold.
[[nodiscard]] std::string brokenPromise(const Image& image, std::size_t bytes);
/// A mesh, a model that exists, finite numbers, directions that are directions.
[[nodiscard]] std::string brokenPromise(const Scene& scene);
/// Finite vectors, as many values as the model takes, a one-line complaint for each bad row.
[[nodiscard]] std::string brokenPromise(const cli::EvalRows& rows);
/// A value for every slot of every parameter, and a text that defines shade().
[[nodiscard]] std::string brokenPromise(const ModelText& text);
/// The same of its text, and an evaluation that comes to an end.
[[nodiscard]] std::string brokenPromise(const Model& model);

} // namespace reflectance::fuzz
