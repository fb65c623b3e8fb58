#include "app/cli/eval_rows.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace reflectance::cli {
namespace {

enum Column { Id, ModelId, Params, N, L, V, LightRgb, LightRadius, ColumnCount };
constexpr std::array<std::string_view, ColumnCount> columnNames{"id", "model", "params",    "N",
                                                                "L",  "V",     "light_rgb", "light_radius"};

using Fields = std::array<std::string_view, ColumnCount>;

std::vector<std::string_view> fieldsOf(std::string_view line)
{
    std::vector<std::string_view> fields = split(line, ',');
    for (std::string_view& field : fields)
        field = trimmed(field);
    return fields;
}

Error bad(Column column, const std::string& why)
{
    return Error{"column " + std::string(columnNames[column]) + ": " + why};
}

Result<Vec3d> parseVector(Column column, std::string_view text)
{
    std::array<double, 3> numbers{};
    const auto pieces = words(text);
    bool good = pieces.size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
        const auto number = parseNumber(pieces[i]);
        good = number && std::isfinite(*number);
        numbers[i] = number.value_or(0.0);
    }
    if (!good)
        return bad(column, "'" + std::string(text) + "' is not three finite numbers parted by blanks");
    return Vec3d{numbers[0], numbers[1], numbers[2]};
}

/// One light per piece between bars; lists of one serve all lights.
Result<std::vector<ObservedLight>> parseLights(const Fields& fields)
{
    const auto directions = split(fields[L], '|');
    const auto colors = split(fields[LightRgb], '|');
    const auto radii = split(fields[LightRadius], '|');
    if (colors.size() != directions.size())
        return bad(LightRgb, "holds " + std::to_string(colors.size()) + " lights and L holds " +
                                 std::to_string(directions.size()) + "; give as many");
    if (radii.size() != 1 && radii.size() != directions.size())
        return bad(LightRadius, "give one radius, or one for each light");
    std::vector<ObservedLight> lights;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto direction = parseVector(L, directions[i]);
        const auto color = parseVector(LightRgb, colors[i]);
        if (!direction)
            return direction.error();
        if (!color)
            return color.error();
        const std::string_view radiusText = trimmed(radii[radii.size() == 1 ? 0 : i]);
        const auto radius = radiusText.empty() ? std::optional(0.0) : parseNumber(radiusText);
        if (!radius || !(*radius >= 0.0 && *radius <= 90.0))
            return bad(LightRadius, "'" + std::string(radiusText) + "' is not an angle within 0 .. 90 degrees");
        lights.push_back({*direction, *color, *radius});
    }
    return lights;
}

/// Tables by file name: rows that name the same one share it, so that they are evaluated together.
using Tables = std::map<std::string, std::shared_ptr<const MeasuredTable>, std::less<>>;

/// "file=PATH" of a table that an earlier row has read.
const std::shared_ptr<const MeasuredTable>* known(std::string_view assignment, const Tables& tables)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos || trimmed(assignment.substr(0, equals)) != "file")
        return nullptr;
    const auto found = tables.find(trimmed(assignment.substr(equals + 1)));
    return found == tables.end() ? nullptr : &found->second;
}

Result<Surface> parseSurface(Surface surface, std::string_view params, Tables& tables)
{
    for (const std::string_view assignment : split(params, ';')) {
        if (trimmed(assignment).empty())
            continue;
        if (const auto* table = known(assignment, tables))
            surface.table = *table;
        else if (const auto set = setOnSurface(assignment, surface); !set)
            return bad(Params, set.error().sentence());
    }
    if (!surface.tableFile.empty())
        tables[surface.tableFile] = surface.table;
    if (const auto complete = checkSurface(surface); !complete)
        return bad(Params, complete.error().message);
    return surface;
}

Result<EvalRow> parseRow(const Fields& fields, Tables& tables, const std::shared_ptr<const Model>& own)
{
    EvalRow row;
    row.id = fields[Id];
    Surface named;
    named.model = fields[ModelId];
    named.own = row.own = own;
    const auto model = findModelOf(named);
    if (!model)
        return bad(ModelId, model.error().message);
    row.model = *model;
    const auto surface = parseSurface(std::move(named), fields[Params], tables);
    if (!surface)
        return surface.error();
    row.values = flatValues(row.model->text, surface->values);
    row.table = surface->table;
    const auto normal = parseVector(N, fields[N]);
    const auto view = parseVector(V, fields[V]);
    if (!normal)
        return normal.error();
    if (!view)
        return view.error();
    auto lights = parseLights(fields);
    if (!lights)
        return lights.error();
    row.observation = {*normal, *view, *std::move(lights)};
    return row;
}

constexpr std::size_t absent = static_cast<std::size_t>(-1);

/// Which field of a line holds which column.
Result<std::array<std::size_t, ColumnCount>> parseHeader(std::string_view line, const std::string& file)
{
    const auto names = fieldsOf(line);
    std::array<std::size_t, ColumnCount> places{};
    for (std::size_t c = 0; c < ColumnCount; ++c) {
        const auto found = std::find(names.begin(), names.end(), columnNames[c]);
        places[c] = found == names.end() ? absent : static_cast<std::size_t>(found - names.begin());
        const bool optional = c == Params || c == LightRadius;
        if (places[c] == absent && !optional)
            return Error{"the header has no column '" + std::string(columnNames[c]) +
                             "'; it must name id, model, params, N, L, V, light_rgb",
                         file, 1};
    }
    return places;
}

} // namespace

Result<EvalRows> parseEvalRows(std::string_view csv, const std::string& file, const std::shared_ptr<const Model>& own)
{
    if (csv.starts_with("\xEF\xBB\xBF"))
        csv.remove_prefix(3);
    const auto lines = split(csv, '\n');
    const auto places = parseHeader(lines.front(), file);
    if (!places)
        return places.error();
    EvalRows result;
    Tables tables;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (trimmed(lines[i]).empty())
            continue;
        const auto parts = fieldsOf(lines[i]);
        Fields fields;
        bool complete = true;
        for (std::size_t c = 0; c < ColumnCount; ++c) {
            const std::size_t place = (*places)[c];
            complete = complete && (place == absent || place < parts.size());
            fields[c] = place < parts.size() ? parts[place] : std::string_view();
        }
        auto row = complete ? parseRow(fields, tables, own)
                            : Result<EvalRow>(Error{"the row has fewer fields than the header"});
        if (row)
            result.rows.push_back(*std::move(row));
        else
            result.bad.push_back({row.error().message, file, static_cast<long>(i + 1)});
    }
    return result;
}

} // namespace reflectance::cli
