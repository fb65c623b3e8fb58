// Models of the user's own in the window: put to use, watched, and renewed when their file is saved.
#pragma once

#include "core/base/result.h"
#include "core/render/gl/gl_renderer.h"
#include "core/scene/scene.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace reflectance::explorer {

/// Whether the driver compiles it; the error names file and line.
[[nodiscard]] Result<void> compiled(GlRenderer& renderer, const Model& model);

void useModel(Surface& surface, std::shared_ptr<const Model> model, const std::string& path);

/// The new version of the model of that file in every variant that has it. False where none has.
bool renewIn(Scene& scene, const std::shared_ptr<const Model>& model, const std::string& path);

/// Looks at a file's time of change, twice a second at most.
class OwnModelWatch {
public:
    using Time = std::chrono::steady_clock::time_point;

    void watch(const std::string& path);
    void forget() { path_.clear(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] bool watches() const { return !path_.empty(); }

    /// What the file holds now, once after each time that it was saved; nothing otherwise.
    [[nodiscard]] std::optional<Result<std::shared_ptr<const Model>>> saved(Time now);

    static constexpr std::chrono::milliseconds pause{500};

private:
    std::string path_;
    std::filesystem::file_time_type seen_{};
    Time looked_{};
};

} // namespace reflectance::explorer
