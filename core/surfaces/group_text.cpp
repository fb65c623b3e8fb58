#include "core/surfaces/group_text.h"

#include "core/base/number_list.h"
#include "core/base/text.h"

#include <algorithm>
#include <map>

namespace reflectance {
namespace {

/// What the comment lines say.
struct Head {
    std::shared_ptr<SurfaceGroup> group = std::make_shared<SurfaceGroup>();
    std::map<std::string, std::vector<double>, std::less<>> scales; ///< by parameter
    std::vector<std::string> assignments;
};

/// Lower case, with a hyphen for every run of what an id cannot hold: "Roof Shingle (zoomed)" is "roof-shingle-zoomed".
std::string slug(std::string_view name)
{
    std::string made;
    for (const char c : lowered(name)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        if (plain)
            made += c;
        else if (!made.empty() && made.back() != '-')
            made += '-';
    }
    return made.ends_with('-') ? made.substr(0, made.size() - 1) : made;
}

Result<void> readHeadLine(std::string_view line, Head& head)
{
    const std::string_view content = trimmed(line.substr(1));
    const std::size_t blank = std::min(content.find(' '), content.size());
    const std::string_view key = content.substr(0, blank);
    const std::string value(trimmed(content.substr(blank)));
    const std::map<std::string_view, std::string*> texts{{"group", &head.group->name},
                                                         {"model", &head.group->model},
                                                         {"source", &head.group->source},
                                                         {"convention", &head.group->convention},
                                                         {"note", &head.group->note}};
    if (const auto text = texts.find(key); text != texts.end()) {
        *text->second = value;
    } else if (key == "set") {
        head.assignments.push_back(value);
    } else if (key == "scale") {
        const std::size_t end = std::min(value.find(' '), value.size());
        const auto numbers = numbersInWords(std::string_view(value).substr(end));
        if (!numbers || numbers->size() != 3)
            return Error{"'scale' needs a parameter and three numbers"};
        head.scales[value.substr(0, end)] = *numbers;
    } else {
        return Error{"nothing is known of '" + std::string(key) +
                     "'; write group, model, source, convention, note, scale or set"};
    }
    return {};
}

/// A number for each channel, times the channel's factor.
std::vector<double> scaled(std::vector<double> numbers, const std::vector<double>& factors)
{
    if (numbers.size() == 1)
        numbers.resize(3, numbers[0]);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] *= factors[i % 3];
    return numbers;
}

Result<void> readCell(const std::string& column, std::string_view cell, const ModelText& model, const Head& head,
                      LibrarySurface& surface)
{
    if (column == "name") {
        surface.name = std::string(cell);
        return {};
    }
    const Parameter* parameter = model.find(column);
    if (!parameter) {
        if (!cell.empty())
            surface.facts.push_back({column, std::string(cell)});
        return {};
    }
    auto numbers = numbersInWords(cell);
    if (!numbers || numbers->empty())
        return Error{"'" + std::string(cell) + "' is no list of numbers for " + column};
    if (const auto scale = head.scales.find(column); scale != head.scales.end())
        numbers = scaled(*std::move(numbers), scale->second);
    auto checked = checkedValue(*parameter, *numbers);
    if (!checked)
        return checked.error();
    surface.values[column] = *std::move(checked);
    return {};
}

Result<LibrarySurface> readRow(std::string_view line, const std::vector<std::string>& columns, const ModelText& model,
                               const Head& head)
{
    const auto cells = split(line, ',');
    if (cells.size() != columns.size())
        return Error{"this row has " + std::to_string(cells.size()) + " cells where the head names " +
                     std::to_string(columns.size())};
    LibrarySurface surface;
    surface.group = head.group;
    for (const std::string& assignment : head.assignments)
        if (const auto set = setParameter(model, assignment, surface.values); !set)
            return set.error();
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (const auto read = readCell(columns[i], trimmed(cells[i]), model, head, surface); !read)
            return read.error();
    if (slug(surface.name).empty())
        return Error{"this surface has no name"};
    surface.id = head.group->id + "/" + slug(surface.name);
    return surface;
}

/// The columns; refused where none is "name" or where a scale speaks of a column that is not there.
Result<std::vector<std::string>> readColumns(std::string_view line, const Head& head)
{
    std::vector<std::string> columns;
    for (const std::string_view column : split(line, ','))
        columns.emplace_back(trimmed(column));
    const auto has = [&](const std::string& name) {
        return std::find(columns.begin(), columns.end(), name) != columns.end();
    };
    if (!has("name"))
        return Error{"no column is called 'name'"};
    for (const auto& [name, factors] : head.scales)
        if (!has(name))
            return Error{"'scale' speaks of '" + name + "', which no column is called"};
    return columns;
}

} // namespace

Result<std::vector<LibrarySurface>> parseSurfaceGroup(std::string_view id, std::string_view text,
                                                      const std::string& file)
{
    Head head;
    head.group->id = std::string(id);
    std::vector<std::string> columns;
    std::vector<LibrarySurface> surfaces;
    const Model* model = nullptr;
    long number = 0;
    const auto here = [&](const Error& error) { return Error{error.message, file, number}; };
    for (const std::string_view raw : split(text, '\n')) {
        ++number;
        const std::string_view line = trimmed(raw);
        if (line.empty())
            continue;
        if (line.front() == '#') {
            if (const auto read = readHeadLine(line, head); !read)
                return here(read.error());
        } else if (!model) {
            const auto found = findModel(head.group->model);
            if (!found)
                return here(found.error());
            auto read = readColumns(line, head);
            if (!read)
                return here(read.error());
            model = *found;
            columns = *std::move(read);
        } else {
            auto surface = readRow(line, columns, model->text, head);
            if (!surface)
                return here(surface.error());
            const auto same = [&](const LibrarySurface& other) { return other.id == surface->id; };
            if (std::any_of(surfaces.begin(), surfaces.end(), same))
                return here(Error{"a surface '" + surface->id + "' stands above already"});
            surfaces.push_back(*std::move(surface));
        }
    }
    return surfaces;
}

} // namespace reflectance
