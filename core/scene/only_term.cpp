#include "core/scene/only_term.h"

#include "core/base/text.h"
#include "core/reflectance/walked/dissected.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr std::string_view offDiagonal = "offdiagonal", lightPrefix = "light:";
constexpr std::size_t besideDiagonal[] = {1, 2, 3, 5, 6, 7};

/// K where it is a matrix.
const Parameter* matrixOf(const ModelText& text)
{
    const Parameter* K = text.find("K");
    return K && K->kind == ParameterKind::Matrix ? K : nullptr;
}

bool hasOffDiagonal(const Surface& surface)
{
    const Parameter* K = matrixOf(modelOf(surface).text);
    if (!K)
        return false;
    const std::vector<double> rows = valueOf(*K, surface.values);
    return std::ranges::any_of(besideDiagonal, [&](std::size_t i) { return rows[i] != 0.0; });
}

void blacken(Surface& surface)
{
    surface.model = "lambert";
    surface.values["kd"] = {0.0};
}

void keepTerm(Surface& surface, std::string_view name)
{
    const auto parts = walked::dissected(modelOf(surface).text);
    const auto found = std::ranges::find(parts->terms, name, &walked::Term::name);
    if (found == parts->terms.end())
        return blacken(surface);
    if (parts->alone.empty())
        return; // the formula is this term
    surface.own = parts->alone[static_cast<std::size_t>(found - parts->terms.begin())];
    surface.modelFile.clear();
}

void keepOffDiagonal(Surface& surface)
{
    const Parameter* K = matrixOf(modelOf(surface).text);
    if (!K)
        return blacken(surface);
    std::vector<double> rows = valueOf(*K, surface.values);
    for (const std::size_t diagonal : {0U, 4U, 8U})
        rows[diagonal] = 0.0;
    if (!walked::dissected(modelOf(surface).text)->alone.empty())
        keepTerm(surface, "diffuse");
    surface.values["K"] = std::move(rows);
}

template <class Keep> void eachSurface(Scene& scene, Keep keep)
{
    keep(scene.surface);
    if (scene.other)
        keep(*scene.other);
}

Error unknown(const Scene& scene, std::string_view term)
{
    return Error{"the scene has no term '" + std::string(term) +
                 "' that could be seen alone; choose one of: " + joined(termsAlone(scene))};
}

Result<Scene> onlyLight(Scene scene, std::string_view term)
{
    const auto number = parseInteger(term.substr(lightPrefix.size()));
    if (!number || *number < 1 || static_cast<std::size_t>(*number) > scene.lights.size())
        return unknown(scene, term);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].on = i + 1 == static_cast<std::size_t>(*number);
    if (modelOf(scene).text.usesEnvironment)
        scene.environment.kind = EnvironmentKind::None;
    return scene;
}

} // namespace

std::vector<std::string> termsAlone(const Scene& scene)
{
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
        if (std::ranges::find(names, name) == names.end())
            names.push_back(name);
    };
    Scene seen = scene;
    eachSurface(seen, [&](const Surface& surface) {
        const auto parts = walked::dissected(modelOf(surface).text);
        for (std::size_t i = 0; i < parts->alone.size(); ++i)
            add(parts->terms[i].name);
    });
    eachSurface(seen, [&](const Surface& surface) {
        if (hasOffDiagonal(surface))
            add(std::string(offDiagonal));
    });
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        add(std::string(lightPrefix) + std::to_string(i + 1));
    return names;
}

Result<Scene> onlyTerm(Scene scene, std::string_view term)
{
    if (term.starts_with(lightPrefix))
        return onlyLight(std::move(scene), term);
    const std::vector<std::string> known = termsAlone(scene);
    if (std::ranges::find(known, term) == known.end())
        return unknown(scene, term);
    if (term == offDiagonal)
        eachSurface(scene, keepOffDiagonal);
    else
        eachSurface(scene, [&](Surface& surface) { keepTerm(surface, term); });
    return scene;
}

} // namespace reflectance
