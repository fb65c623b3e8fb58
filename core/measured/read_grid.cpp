#include "core/measured/readers.h"

#include <algorithm>
#include <limits>
#include <span>

namespace reflectance {

Result<Measurement> finished(Table table, const ReadContext& context)
{
    const auto checked = checkedTable(table);
    if (!checked)
        return Error{checked.error().message, context.file};
    Provenance counted = table.provenance;
    counted.samples = table.samples();
    std::size_t holes = 0;
    for (std::size_t sample = 0; sample < table.samples(); ++sample) {
        const auto values = std::span(table.values).subspan(sample * table.channels, table.channels);
        const bool isHole = std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
        const bool isNegative = std::any_of(values.begin(), values.end(), [](double v) { return v < 0.0; });
        if (std::any_of(values.begin(), values.end(), [](double v) { return std::fabs(v) > largestBrdf; }))
            return Error{"holds a number that is too large; numbers up to 1e100 are possible", context.file};
        holes += isHole ? 1 : 0;
        counted.negatives += !isHole && isNegative ? 1 : 0;
        if (isHole)
            std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    }
    if (holes == table.samples())
        return Error{"holds nothing but holes", context.file};
    counted.holes = holes;
    if (table.provenance.samples == 0)
        table.provenance = std::move(counted);
    return Measurement(std::move(table));
}

} // namespace reflectance
