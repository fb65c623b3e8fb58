#include "core/surfaces/library.h"

#include "core/base/embedded.h"
#include "core/base/text.h"
#include "core/surfaces/group_text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

namespace reflectance {

std::span<const EmbeddedFile> surfaceFiles(); // made by the build from core/surfaces/data

namespace {

std::vector<LibrarySurface> readLibrary()
{
    std::vector<LibrarySurface> all;
    for (const EmbeddedFile& file : surfaceFiles()) {
        auto surfaces = parseSurfaceGroup(file.name, file.bytes, std::string(file.name) + ".csv");
        if (!surfaces) { // cannot happen: a test reads the same files
            std::cerr << surfaces.error().sentence() << '\n';
            std::abort();
        }
        all.insert(all.end(), std::make_move_iterator(surfaces->begin()), std::make_move_iterator(surfaces->end()));
    }
    return all;
}

/// Everything that a search looks at.
std::string searchedText(const LibrarySurface& surface)
{
    const SurfaceGroup& group = *surface.group;
    std::string text = surface.id + '\n' + surface.name + '\n' + group.name + '\n' + group.model + '\n' + group.source +
                       '\n' + group.note;
    for (const SurfaceFact& fact : surface.facts)
        text += '\n' + fact.name + ' ' + fact.text;
    return lowered(text);
}

} // namespace

const std::vector<LibrarySurface>& surfaceLibrary()
{
    static const std::vector<LibrarySurface> surfaces = readLibrary();
    return surfaces;
}

std::vector<std::shared_ptr<const SurfaceGroup>> surfaceGroups()
{
    std::vector<std::shared_ptr<const SurfaceGroup>> groups;
    for (const LibrarySurface& surface : surfaceLibrary())
        if (groups.empty() || groups.back() != surface.group)
            groups.push_back(surface.group);
    return groups;
}

Result<const LibrarySurface*> findSurface(std::string_view idOrName)
{
    std::vector<std::string> everyName;
    std::vector<const LibrarySurface*> named;
    for (const LibrarySurface& surface : surfaceLibrary()) {
        if (surface.id == idOrName)
            return &surface;
        const std::string shortId = surface.id.substr(surface.group->id.size() + 1);
        if (lowered(surface.name) == lowered(idOrName) || shortId == idOrName)
            named.push_back(&surface);
        everyName.push_back(surface.id);
        everyName.push_back(shortId);
    }
    if (named.size() == 1)
        return named.front();
    if (named.empty())
        return Error{"unknown surface '" + std::string(idOrName) + "'; did you mean '" +
                     nearestName(lowered(idOrName), everyName) + "'? 'reflectance surfaces' lists them"};
    std::vector<std::string> ids;
    for (const LibrarySurface* surface : named)
        ids.push_back(surface->id);
    return Error{"several surfaces are called '" + std::string(idOrName) + "'; choose one of: " + joined(ids)};
}

std::vector<const LibrarySurface*> searchSurfaces(std::string_view wanted, std::string_view group)
{
    const std::string lower = lowered(wanted);
    const auto wantedWords = words(lower);
    std::vector<const LibrarySurface*> found;
    for (const LibrarySurface& surface : surfaceLibrary()) {
        if (!group.empty() && surface.group->id != group)
            continue;
        const std::string text = wantedWords.empty() ? std::string() : searchedText(surface);
        if (std::all_of(wantedWords.begin(), wantedWords.end(),
                        [&](std::string_view word) { return text.find(word) != std::string::npos; }))
            found.push_back(&surface);
    }
    return found;
}

ParameterValues withSurface(const LibrarySurface& surface, ParameterValues values)
{
    const auto model = findModel(surface.group->model); // a test holds every group to a model of the catalogue
    for (const Parameter& parameter : (*model)->text.parameters)
        values.erase(parameter.name);
    for (const auto& [name, numbers] : surface.values)
        values[name] = numbers;
    return values;
}

std::string inBrief(const std::vector<double>& numbers)
{
    constexpr std::array<std::size_t, 6> offDiagonal{1, 2, 3, 5, 6, 7};
    std::vector<double> shown = numbers;
    if (numbers.size() == 9 &&
        std::all_of(offDiagonal.begin(), offDiagonal.end(), [&](std::size_t i) { return numbers[i] == 0.0; }))
        shown = {numbers[0], numbers[4], numbers[8]};
    if (shown.size() == 3 && shown[0] == shown[1] && shown[1] == shown[2])
        shown.resize(1);
    if (shown.size() > 9)
        return std::to_string(shown.size()) + " numbers";
    std::vector<std::string> texts;
    for (const double number : shown)
        texts.push_back(general(number, 6));
    return joined(texts, " ");
}

bool isSurface(const LibrarySurface& surface, const ParameterValues& values)
{
    const auto& text = (*findModel(surface.group->model))->text;
    return flatValues(text, values) == flatValues(text, surface.values);
}

} // namespace reflectance
