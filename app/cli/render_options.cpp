#include "app/cli/render_options.h"

#include "app/explorer/user_folders.h"
#include "core/base/named_value.h"

namespace reflectance::cli {
namespace {

/// Where the words of --shading evaluate the model; "pixel", the first, means at every sample of it.
Place placeNamed(const std::string& shading)
{
    constexpr NamedValue<Place> places[] = {{"pixel", Place::Sample},
                                            {"fragment", Place::Fragment},
                                            {"once", Place::Pixel},
                                            {"vertex", Place::Vertex},
                                            {"face", Place::Face}};
    for (const NamedValue<Place>& named : places)
        if (named.name == shading)
            return named.value;
    return Place::Sample;
}

VariantView shownNamed(const std::string& variant)
{
    for (const VariantView shown :
         {VariantView::B, VariantView::SideBySide, VariantView::Wipe, VariantView::Difference})
        if (nameOf(shown) == variant)
            return shown;
    return VariantView::A;
}

} // namespace

Result<RenderPlan> planFrom(const RenderOptions& options)
{
    RenderPlan plan;
    plan.backend = options.backend == "gl" ? Backend::Gl : options.backend == "cpu" ? Backend::Cpu : Backend::Auto;
    plan.context = contextNamed(options.context);
    if (!options.noCache)
        plan.programs = explorer::programsFolder();
    plan.frames = options.frames;
    plan.place = placeNamed(options.shading);
    const auto lobe = lobeFormNamed(options.lobe.empty() ? "conditioned" : options.lobe);
    if (!lobe)
        return lobe.error();
    plan.lobe = *lobe;
    plan.specialised = !options.general;
    plan.alsoGeneral = plan.specialised && !options.json.empty(); // what was left out is reported with what it saved
    if (options.precision.empty())
        return plan;
    if (options.precision == "glsl")
        plan.backend = Backend::Gl;
    else if (plan.backend == Backend::Gl)
        return Error{"--precision " + options.precision +
                     " belongs to the CPU renderer; GL computes in glsl; leave one of the two flags out"};
    else
        plan.backend = Backend::Cpu;
    plan.precision = options.precision == "float"  ? Precision::Float
                     : options.precision == "simd" ? Precision::Simd
                                                   : Precision::Double;
    return plan;
}

RenderOptions completed(RenderOptions options, const PictureRecipe& recipe)
{
    if (options.scene.size.empty())
        options.scene.size = std::to_string(recipe.width) + "x" + std::to_string(recipe.height);
    if (!options.scene.samples)
        options.scene.samples = recipe.samplesPerAxis * recipe.samplesPerAxis;
    options.scene.showHoles = options.scene.showHoles || recipe.holes;
    if (options.variant.empty()) {
        options.variant = nameOf(recipe.shown);
        options.divider = recipe.divider;
    }
    if (options.lobe.empty())
        options.lobe = recipe.lobe;
    if (options.term.empty() && options.lens.empty())
        options.term = recipe.term;
    // Flags that choose an arithmetic go together: one of them, and the picture's own no longer counts.
    if (options.backend != "auto" || !options.precision.empty() || !options.shading.empty() || !options.lens.empty())
        return options;
    if (recipe.lens != "none") {
        options.lens = recipe.lens;
        return options;
    }
    options.precision = recipe.precision;
    options.shading = recipe.shading;
    return options;
}

PictureRecipe recipeFrom(const RenderOptions& options, const RenderSettings& settings, const std::string& backend,
                         const std::string& precision)
{
    PictureRecipe recipe{settings.width, settings.height, settings.samplesPerAxis};
    recipe.backend = backend.starts_with("gl") ? "gl" : "cpu";
    recipe.precision = precision.substr(0, precision.find(' ')); // the lanes' name follows "simd"
    recipe.shading = options.shading.empty() ? "pixel" : options.shading;
    recipe.lobe = options.lobe.empty() ? "conditioned" : options.lobe;
    recipe.lens = options.lens.empty() ? "none" : options.lens;
    recipe.shown = shownNamed(options.variant);
    recipe.divider = options.divider;
    recipe.term = options.term == "all" ? std::string() : options.term;
    recipe.holes = options.scene.showHoles;
    return recipe;
}

} // namespace reflectance::cli
