// One picture by whichever renderer is asked for, without a window: what `render` and the start without a display use.
#pragma once

#include "core/image/image.h"
#include "core/reflectance/arithmetic.h"
#include "core/render/cpu/shading_places.h"
#include "core/render/headless/headless_context.h"
#include "core/render/settings.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

enum class Backend { Auto, Gl, Cpu };

struct RenderPlan {
    Backend backend = Backend::Auto;         ///< Auto: GL where a context opens, else the CPU
    Precision precision = Precision::Double; ///< of the CPU renderer
    ContextKind context = ContextKind::Any;
    int frames = 1;              ///< shadings; more than one for timing
    Place place = Place::Sample; ///< where the model is evaluated; the GL renderer knows Sample, Fragment and Pixel
    LobeForm lobe = LobeForm::Conditioned;
    bool specialised = true;             ///< see Arithmetic
    std::filesystem::path programs = {}; ///< where linked shader programs are kept; empty: nowhere
    bool alsoGeneral = false;            ///< time the general path as well, with more than one frame
};

struct Rendered {
    Image image;
    std::string backend;                 ///< "cpu", "gl (osmesa)"
    std::string precision;               ///< "double", "glsl"
    double firstFrameMilliseconds = 0.0; ///< visibility and shading, from nothing
    double shadingMilliseconds = 0.0;    ///< shading again: the median of the frames after the first; 0 for one frame
    double generalMilliseconds = 0.0;    ///< the same by the general path; 0 where it was not timed
    std::uint64_t leftOutBytes = 0;      ///< of textures that the scene does not require
};

/// `progress` lets another thread watch and stop the CPU renderer; the Error then says that it was stopped.
[[nodiscard]] Result<Rendered> renderPicture(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                                             Progress* progress = nullptr);

/// "double", "simd (avx2)".
[[nodiscard]] std::string nameWithLanes(Precision precision);

/// "osmesa" and "egl"; anything else is Any.
[[nodiscard]] ContextKind contextNamed(std::string_view name);

} // namespace reflectance
