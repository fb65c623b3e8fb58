// CSV: a header that names columns and units, then rows. docs/tables.md gives the grammar.
#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/csv_header.h"
#include "core/measured/grid_rows.h"
#include "core/measured/grid_shape.h"
#include "core/measured/lines.h"
#include "core/measured/readers.h"

#include <algorithm>
#include <limits>

namespace reflectance {
namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

/// What comments say.
struct Remarks {
    std::string name;
    std::optional<Interpolation> interpolation;
};

/// "# interpolation cubic", "# name brick"; other comments are passed over.
void takeRemark(std::string_view line, Remarks& remarks)
{
    const auto said = words(line.substr(1));
    if (said.size() < 2)
        return;
    if (said[0] == "name")
        remarks.name = printable(trimmed(line.substr(line.find("name") + 4)));
    for (const Interpolation i : {Interpolation::Nearest, Interpolation::Linear, Interpolation::MonotoneCubic})
        if (said[0] == "interpolation" && said[1] == nameOf(i))
            remarks.interpolation = i;
}

class CsvReader {
public:
    CsvReader(std::string_view text, const ReadContext& context) : lines_(text), context_(context), rows_({}) {}

    [[nodiscard]] Result<Measurement> read()
    {
        const auto line = nextLine();
        if (!line)
            return Error{"has no header", context_.file};
        auto header = parseCsvHeader(*line);
        if (!header)
            return fail(header.error().message);
        header_ = *std::move(header);
        rows_ = GridRows(header_.angleNames);
        if (const auto problem = readRows())
            return *problem;
        if (values_.empty())
            return Error{"has a header and no row", context_.file};
        return header_.isScattered ? scattered() : grid();
    }

private:
    [[nodiscard]] Error fail(const std::string& sentence) const { return {sentence, context_.file, lines_.number()}; }

    /// The next line that is neither empty nor a comment.
    [[nodiscard]] std::optional<std::string_view> nextLine()
    {
        while (const auto line = lines_.next()) {
            if (line->starts_with('#'))
                takeRemark(*line, remarks_);
            else if (!trimmed(*line).empty())
                return line;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Error> readRows()
    {
        std::vector<double> numbers;
        while (const auto line = nextLine()) {
            numbers.clear();
            for (const std::string_view field : split(*line, ',')) {
                const auto value = parseNumber(trimmed(field));
                if (!value)
                    return fail(quotedPiece(trimmed(field)) + " is not a number");
                numbers.push_back(*value);
            }
            if (numbers.size() != header_.columns)
                return fail("the row has " + std::to_string(numbers.size()) + " fields, the header " +
                            std::to_string(header_.columns));
            if (auto problem = takeRow(numbers))
                return problem;
        }
        return std::nullopt;
    }

    /// `numbers` in the order of the columns, so that sorting is judged as the file is written.
    [[nodiscard]] std::optional<Error> takeRow(const std::vector<double>& numbers)
    {
        std::vector<double> written;
        for (std::size_t column = 0; column < numbers.size(); ++column)
            if (std::count(header_.angleColumn.begin(), header_.angleColumn.end(), column) > 0)
                written.push_back(numbers[column]);
        std::vector<double> at; // in the order of the system, radians
        for (const std::size_t column : header_.angleColumn)
            at.push_back(header_.inDegrees ? radians(numbers[column]) : numbers[column]);
        if (auto problem = outside(at))
            return problem;
        if (!header_.isScattered)
            if (const auto added = rows_.add(written); !added)
                return fail(added.error().message);
        at.resize(4);
        const DirectionPair directions = header_.isScattered
                                             ? DirectionPair{directionAt(at[0], at[1]), directionAt(at[2], at[3])}
                                             : directionsAt(header_.system, {at[0], at[1], at[2]});
        for (const std::size_t column : header_.valueColumn) {
            if (std::isinf(numbers[column]))
                return fail("a value is infinite; write nan for what was not measured");
            const auto f = brdfFrom(header_.quantity, numbers[column], directions);
            if (f && std::fabs(*f) > largestBrdf)
                return fail("a value is too large; numbers up to 1e100 are possible");
            horizons_ += f ? 0 : 1;
            values_.push_back(f.value_or(hole));
        }
        if (header_.isScattered) {
            if (L_.size() == mostScattered)
                return fail("holds more than " + std::to_string(mostScattered) +
                            " scattered samples; thin them out or bring them onto a grid");
            L_.push_back(directions.L);
            V_.push_back(directions.V);
        }
        return std::nullopt;
    }

    /// Of angles in the order of the system, radians.
    [[nodiscard]] std::optional<Error> outside(const std::vector<double>& at) const
    {
        for (std::size_t i = 0; i < at.size(); ++i) {
            const bool hasRange = !header_.isScattered || i % 2 == 0; // a scattered azimuth has none
            const double largest = largestAngle(header_.system, header_.isScattered ? 0 : i);
            if (std::isfinite(at[i]) && (!hasRange || (at[i] >= 0.0 && at[i] <= largest + 1e-9)))
                continue;
            const std::string_view name = header_.isScattered ? scatteredAngles[i] : angleNames(header_.system)[i];
            return fail("the angle " + std::string(name) + " is " + general(at[i] / radians(1.0), 9) +
                        " degrees; 0 .. " + general(largest / radians(1.0), 9) + " are possible");
        }
        return std::nullopt;
    }

    void describeInto(Provenance& provenance) const
    {
        provenance.name = remarks_.name.empty() ? context_.file : remarks_.name;
        provenance.format = header_.isScattered ? "CSV (scattered)" : "CSV";
        provenance.convention = describe(header_.quantity) + "; " + (header_.inDegrees ? "degrees" : "radians");
        if (horizons_ > 0)
            provenance.warnings.push_back(std::to_string(horizons_) +
                                          " numbers stand at the horizon, where the cosine leaves nothing of f");
    }

    [[nodiscard]] Result<Measurement> grid();
    [[nodiscard]] Result<Measurement> scattered();

    Lines lines_;
    const ReadContext& context_;
    CsvHeader header_;
    Remarks remarks_;
    GridRows rows_;
    std::vector<double> values_;
    std::vector<Vec3d> L_, V_;
    std::size_t horizons_ = 0;
};

Result<Measurement> CsvReader::grid()
{
    auto axes = rows_.axes();
    if (!axes)
        return Error{axes.error().message, context_.file};
    for (auto& axis : *axes)
        for (double& angle : axis)
            angle = header_.inDegrees ? radians(angle) : angle;
    Table table;
    table.system = header_.system;
    table.channels = header_.valueColumn.size();
    table.interpolation = remarks_.interpolation.value_or(Interpolation::Linear);
    describeInto(table.provenance);
    table.axes = *std::move(axes);
    table.values = std::move(values_);
    // The header's columns may stand in another order than the system's angles.
    std::vector<std::size_t> order;
    for (const std::string_view name : angleNames(table.system))
        order.push_back(static_cast<std::size_t>(std::find(header_.angleNames.begin(), header_.angleNames.end(), name) -
                                                 header_.angleNames.begin()));
    table = reordered(table, order);
    return finished(closedAround(std::move(table)), context_);
}

Result<Measurement> CsvReader::scattered()
{
    ScatteredBrdf brdf = scatteredBrdf(L_, V_, values_, header_.valueColumn.size());
    if (brdf.points.empty())
        return Error{"holds nothing but holes", context_.file};
    describeInto(brdf.provenance);
    return Measurement(std::move(brdf));
}

} // namespace

Result<Measurement> readCsv(std::string_view text, const ReadContext& context)
{
    return CsvReader(text, context).read();
}

} // namespace reflectance
