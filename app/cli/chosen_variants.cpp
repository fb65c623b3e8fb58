#include "app/cli/chosen_variants.h"

#include "core/scene/variants.h"

#include <algorithm>
#include <array>

namespace reflectance::cli {
namespace {

constexpr std::array<std::string_view, 5> ways = {"A", "B", "side", "wipe", "difference"};

Result<Surface> surfaceNamed(const Scene& scene, const char* flag, const std::string& name)
{
    const auto variant = findVariant(scene, name);
    if (!variant)
        return Error{std::string(flag) + ": " + variant.error().message};
    return scene.variants[*variant].surface;
}

} // namespace

Result<void> chooseVariants(RenderOptions& options, Scene& scene)
{
    if (!options.variantA.empty()) {
        auto surface = surfaceNamed(scene, "--a", options.variantA);
        if (!surface)
            return surface.error();
        scene.surface = *std::move(surface);
    }
    if (!options.variantB.empty()) {
        auto surface = surfaceNamed(scene, "--b", options.variantB);
        if (!surface)
            return surface.error();
        scene.other = *std::move(surface);
    }
    if (options.variant.empty() || std::find(ways.begin(), ways.end(), options.variant) != ways.end())
        return {};
    auto surface = surfaceNamed(scene, "--variant", options.variant);
    if (!surface)
        return Error{surface.error().message + "; or write A, B, side, wipe or difference"};
    scene.surface = *std::move(surface);
    options.variant = "A";
    return {};
}

} // namespace reflectance::cli
