#include "core/sensor/response_curve.h"

#include "core/base/columns.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reflectance {
namespace {

constexpr std::size_t places = 4097;
constexpr std::size_t mostLines = 100'000;

using Row = std::array<double, 4>; ///< light, red, green, blue

Result<Row> rowOf(const std::vector<std::string_view>& fields)
{
    if (fields.size() != 2 && fields.size() != 4)
        return Error{"there are " + std::to_string(fields.size()) +
                     " columns; give light and one response, or light, red, green and blue"};
    Row row{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto number = parseNumber(fields[i]);
        if (!number || !std::isfinite(*number) || *number < 0.0)
            return Error{"'" + std::string(fields[i]) + "' is not a number from 0 on"};
        row[i] = *number;
    }
    if (fields.size() == 2)
        row[2] = row[3] = row[1];
    return row;
}

Result<void> follows(const Row& row, const std::vector<Row>& rows)
{
    if (rows.size() == mostLines)
        return Error{"there are more than 100000 lines; thin the curve out"};
    if (rows.empty())
        return {};
    if (!(row[0] > rows.back()[0]))
        return Error{"light " + general(row[0], 6) + " follows " + general(rows.back()[0], 6) +
                     "; sort the lines by light and keep each only once"};
    for (std::size_t i = 1; i < 4; ++i)
        if (row[i] < rows.back()[i])
            return Error{"the response falls from " + general(rows.back()[i], 6) + " to " + general(row[i], 6) +
                         "; more light may not give less"};
    return {};
}

double between(const std::vector<Row>& rows, double light, std::size_t channel)
{
    const auto above =
        std::upper_bound(rows.begin(), rows.end(), light, [](double value, const Row& row) { return value < row[0]; });
    if (above == rows.begin())
        return rows.front()[channel];
    if (above == rows.end())
        return rows.back()[channel];
    const Row& low = *(above - 1);
    const double share = (light - low[0]) / ((*above)[0] - low[0]);
    return std::lerp(low[channel], (*above)[channel], share);
}

ResponseCurve sampled(const std::vector<Row>& rows)
{
    const double full = rows.back()[0];
    const double largest = std::max({rows.back()[1], rows.back()[2], rows.back()[3]});
    ResponseCurve curve;
    curve.texels.reserve(4 * places);
    for (std::size_t i = 0; i < places; ++i) {
        const double light = full * static_cast<double>(i) / static_cast<double>(places - 1);
        for (std::size_t channel = 1; channel < 4; ++channel)
            curve.texels.push_back(static_cast<float>(between(rows, light, channel) / largest));
        curve.texels.push_back(0.0F);
    }
    curve.numbers.assign(curve.texels.begin(), curve.texels.end());
    return curve;
}

} // namespace

Result<ResponseCurve> parseResponseCurve(std::string_view csv, const std::string& file)
{
    std::vector<Row> rows;
    long number = 0;
    bool named = false;
    for (const std::string_view text : split(withoutMark(csv), '\n')) {
        ++number;
        const std::string_view line = trimmed(text);
        if (line.empty() || line.starts_with('#'))
            continue;
        const auto fields = columnsOf(line);
        if (rows.empty() && !named && !parseNumber(fields.front())) {
            named = true;
            continue;
        }
        const auto row = rowOf(fields);
        if (!row)
            return Error{row.error().message, file, number};
        if (const auto ordered = follows(*row, rows); !ordered)
            return Error{ordered.error().message, file, number};
        rows.push_back(*row);
    }
    if (rows.size() < 2)
        return Error{"is no response curve: it has fewer than two lines of numbers", file};
    if (!(std::max({rows.back()[1], rows.back()[2], rows.back()[3]}) > 0.0))
        return Error{"is no response curve: every response is 0", file};
    return sampled(rows);
}

Result<ResponseCurve> readResponseCurve(const std::string& file)
{
    const auto text = readWholeFile(file, std::uintmax_t{16} << 20U);
    return text ? parseResponseCurve(*text, file) : Result<ResponseCurve>(text.error());
}

} // namespace reflectance
