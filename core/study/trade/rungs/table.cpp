#include "core/study/tables/sample_model.h"
#include "core/study/trade/rungs/rungs.h"

namespace reflectance::rung {
namespace {

/// Every n-th angle of an axis, and its last.
std::vector<std::size_t> kept(std::size_t angles, std::size_t every)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < angles; i += every)
        indices.push_back(i);
    if (indices.back() != angles - 1)
        indices.push_back(angles - 1);
    return indices;
}

Table thinned(const Table& table, std::size_t every)
{
    Table thin = table;
    std::vector<std::vector<std::size_t>> indices;
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        indices.push_back(kept(table.axes[axis].size(), every));
        thin.axes[axis].clear();
        for (const std::size_t i : indices[axis])
            thin.axes[axis].push_back(table.axes[axis][i]);
    }
    thin.values.clear();
    std::vector<std::size_t> at(indices.size(), 0);
    for (bool more = true; more;) {
        std::size_t sample = 0;
        for (std::size_t axis = 0; axis < at.size(); ++axis)
            sample = sample * table.axes[axis].size() + indices[axis][at[axis]];
        for (std::size_t channel = 0; channel < table.channels; ++channel)
            thin.values.push_back(table.values[sample * table.channels + channel]);
        more = false;
        for (std::size_t axis = at.size(); axis-- > 0 && !more;) { // the last axis runs fastest
            more = ++at[axis] < indices[axis].size();
            if (!more)
                at[axis] = 0;
        }
    }
    return thin;
}

std::string withoutTable(const Scene& scene)
{
    return modelOf(scene).text.usesTable && scene.surface.table ? "" : modelOf(scene).text.name + " is no table";
}

} // namespace

/// Half and difference angles, as measurements of surfaces with highlights are kept: 91 x 46 x 37, linear.
Applied asTable(int /*amount*/, Recipe& recipe)
{
    const Model& model = modelOf(recipe.scene);
    if (model.text.usesTable)
        return {"the surface is a table already"};
    if (model.text.usesEnvironment || model.text.usesLightSize)
        return {"a mirror is no function that a table could hold"};
    auto sampledSurface =
        sampledModel(model, valuesOf(recipe.scene), halfDifferenceShape(91, 46, 37), Interpolation::Linear, 9);
    recipe.scene.lights = shiningLights(recipe.scene); // the values were taken in the sensor convention
    recipe.scene.surface.convention = Convention::Sensor;
    recipe.scene.surface.model = "table";
    recipe.scene.surface.table = measuredTable(std::move(sampledSurface.table));
    return {};
}

Applied thinnedTable(int every, Recipe& recipe)
{
    if (const std::string none = withoutTable(recipe.scene); !none.empty())
        return {none};
    recipe.scene.surface.table =
        measuredTable(thinned(recipe.scene.surface.table->table, static_cast<std::size_t>(every)));
    return {};
}

Applied interpolatedBy(int interpolation, Recipe& recipe)
{
    if (const std::string none = withoutTable(recipe.scene); !none.empty())
        return {none};
    Table table = recipe.scene.surface.table->table;
    const auto wanted = static_cast<Interpolation>(interpolation);
    if (table.interpolation <= wanted)
        return {"the table is interpolated no better than that"};
    table.interpolation = wanted;
    recipe.scene.surface.table = measuredTable(std::move(table));
    return {};
}

} // namespace reflectance::rung
