// Which renderer is sooner done where OpenGL is software: measured once per size of picture on a machine, and kept.
#pragma once

#include "core/render/pictures/render_picture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace reflectance {

inline constexpr std::size_t mostBackendBytes = 1U << 20U; ///< of the file in which times are kept

struct BackendChoice {
    Backend backend = Backend::Auto; ///< Auto or Cpu
    std::string why;                 ///< as a clause: "measured here once: GL 92 ms, CPU 31 ms"
};

/// What both took for a whole picture, GL's context included, in milliseconds.
struct BackendTimes {
    double gl = 0.0, cpu = 0.0;
};

/// Pictures that take about as long: triangles and samples in steps of four, one frame or many.
[[nodiscard]] std::string sizeClass(std::size_t triangles, const RenderSettings& settings, int frames);

/// The CPU, whose default arithmetic is the exact one and which leaves a hundred megabytes of driver closed, unless GL is sooner
/// done by a quarter or more: then Auto, GL that is, and the CPU on the day that no context opens.
[[nodiscard]] BackendChoice soonerOf(const BackendTimes& times);

/// A file of such times, a class per line, under a line that names program and machine. Lines that are damaged are ignored, and
/// all of a file that another program or machine wrote.
[[nodiscard]] std::optional<BackendTimes> timesIn(std::string_view file, const std::string& sizeClass);
[[nodiscard]] std::string withTimes(std::string_view file, const std::string& sizeClass, const BackendTimes& times);

/// Whether every picture that the file tells of was sooner done by the CPU, and there is one: then GL's driver need not be
/// opened before it is known what is drawn.
[[nodiscard]] bool isAlwaysTheCpu(std::string_view file);

/// What the file says of pictures of this size. What it does not say yet is measured by rendering the scene with both, and
/// written down; where a graphics card draws, the picture is too large to be tried, or the file cannot be written, it stays with
/// GL. So does an empty name.
[[nodiscard]] BackendChoice soonerBackend(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                                          const std::filesystem::path& file, Progress* progress = nullptr);

} // namespace reflectance
