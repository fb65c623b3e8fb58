#include "core/study/trade/rungs/rungs.h"

#include "core/measured/table.h"

#include <algorithm>
#include <vector>

namespace reflectance {

namespace {

using namespace rung;

template <class Choice> constexpr int code(Choice choice)
{
    return static_cast<int>(choice);
}

struct Change {
    std::string_view id; ///< as rungList has it at the same place
    Applied (*apply)(int amount, Recipe& recipe);
    int amount = 0;
};

constexpr Change changes[] = {
    {"double", inPrecision, code(Precision::Double)},
    {"float", inPrecision, code(Precision::Float)},
    {"simd", inPrecision, code(Precision::Simd)},
    {"glsl", inPrecision, code(Precision::Glsl)},
    {"half_buffer", halfBuffer},
    {"k_diagonal", diagonalK},
    {"k_white", colourUnderWhite},
    {"k_grey", greyK},
    {"lobe_power", lobeAs, code(LobeForm::Power)},
    {"lobe_squarings", lobeAs, code(LobeForm::Squarings)},
    {"lobe_truncated", lobeAs, code(LobeForm::Truncated)},
    {"lobe_schlick", lobeAs, code(LobeForm::Schlick)},
    {"lobe_table", lobeAs, code(LobeForm::Table)},
    {"general_path", generalPath},
    {"no_highlight", withoutHighlight},
    {"oren_nayar", qualitativeOrenNayar},
    {"eon", energyPreserving, 0},
    {"eon_polynomial", energyPreserving, 1},
    {"lambert", smoothMatte},
    {"once_per_pixel", shadedAt, code(Place::Pixel)},
    {"body_per_vertex", bodyPerVertex},
    {"per_vertex", shadedAt, code(Place::Vertex)},
    {"per_face", shadedAt, code(Place::Face)},
    {"1_sample", samplesPerAxis, 1},
    {"4_samples", samplesPerAxis, 2},
    {"9_samples", samplesPerAxis, 3},
    {"16_samples", samplesPerAxis, 4},
    {"25_samples", samplesPerAxis, 5},
    {"36_samples", samplesPerAxis, 6},
    {"49_samples", samplesPerAxis, 7},
    {"64_samples", samplesPerAxis, 8},
    {"half_size", reducedBy, 2},
    {"quarter_size", reducedBy, 4},
    {"as_table", asTable},
    {"table_every_2nd", thinnedTable, 2},
    {"table_every_4th", thinnedTable, 4},
    {"table_nearest", interpolatedBy, code(Interpolation::Nearest)},
    {"table_linear", interpolatedBy, code(Interpolation::Linear)},
    {"lights_thousandth", withoutFaintLights, 1000},
    {"lights_fiftieth", withoutFaintLights, 50},
    {"one_light_colour", oneLightColour},
    {"one_colour_around", oneColourAround},
    {"nine_coefficients", nineCoefficients},
    {"coarse_surroundings", coarseSurroundings, 4},
};
static_assert(std::ranges::equal(changes, rungList, {}, &Change::id,
                                 [](const RungFacts& rung) { return std::string_view(rung.id); }));

} // namespace

std::span<const Rung> rungs()
{
    static const std::vector<Rung> all = [] {
        std::vector<Rung> made;
        for (std::size_t i = 0; i < std::size(changes); ++i)
            made.push_back({rungList[i], changes[i].apply, changes[i].amount});
        return made;
    }();
    return all;
}

const Rung* findRung(std::string_view id)
{
    const auto all = rungs();
    const auto found = std::find_if(all.begin(), all.end(), [id](const Rung& rung) { return id == rung.id; });
    return found == all.end() ? nullptr : &*found;
}

Applied applyRung(const Rung& rung, Recipe& recipe)
{
    if (rung.axis != RungAxis::Precision && !(recipe.onGl() ? rung.onGl : rung.onCpu))
        return {std::string("the ") + (recipe.onGl() ? "GL" : "CPU") + " renderer does not have it"};
    Recipe changed = recipe;
    Applied applied = rung.apply(rung.amount, changed);
    if (applied.skipped.empty()) {
        changed.rungs.emplace_back(rung.id);
        recipe = std::move(changed);
    }
    return applied;
}

Result<WithRungs> withItsRungs(Recipe recipe)
{
    const std::vector<std::string> ids = recipe.scene.surface.rungs;
    if (auto possible = checkRungs(ids); !possible)
        return possible.error();
    const bool onGl = drawnByGl(ids, recipe.onGl());
    if (onGl != recipe.onGl())
        recipe.precision = onGl ? Precision::Glsl : Precision::Simd;
    WithRungs with{std::move(recipe)};
    for (const Rung& rung : rungs()) // by axis: the arithmetic is known before what depends on it
        if (std::find(ids.begin(), ids.end(), rung.id) != ids.end())
            if (const Applied applied = applyRung(rung, with.recipe); !applied.skipped.empty())
                with.withoutEffect.push_back({rung.id, applied.skipped});
    return with;
}

} // namespace reflectance
