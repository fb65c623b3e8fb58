#include "core/study/sweep/sheet.h"

#include "core/base/digest.h"
#include "core/base/text.h"

namespace reflectance {
namespace {

/// A field of a CSV line (RFC 4180): quoted where it holds a comma or a quote.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// Of what follows the inputs: no figure does.
bool tellsFailure(std::string_view rest)
{
    return rest.starts_with(',');
}

} // namespace

std::string sheetHead(const Study& study, bool timing)
{
    std::string head = "cell,";
    for (const StudyAxis& axis : study.axes)
        if (hasColumn(axis))
            head += field(axis.name) + ",";
    head +=
        "width,height,samples,renderer,scene,covered,mean,max,negative,non_finite,rmse,max_abs,de2000_mean,de2000_max,"
        "flip,";
    return head + (timing ? "ms,error\n" : "error\n");
}

std::string inputsOf(const Cell& cell)
{
    std::string text = std::to_string(cell.index) + ",";
    for (const std::string& label : cell.labels)
        text += field(label) + ",";
    const RenderSettings& s = cell.settings;
    std::string scene = cell.scene;
    if (cell.orbit)
        scene += shortest((*cell.orbit)[0]) + " " + shortest((*cell.orbit)[1]);
    return text + std::to_string(s.width) + "," + std::to_string(s.height) + "," +
           std::to_string(s.samplesPerAxis * s.samplesPerAxis) + "," + std::string(nameOf(cell.renderer)) + "," +
           digestOf(scene) + ",";
}

std::string resultText(const CellResult& result, bool timing)
{
    const Figures& f = result.figures;
    if (!result.error.empty())
        return std::string(timing ? 11 : 10, ',') + field(result.error) + "\n";
    std::string text = shortest(f.covered) + "," + shortest(f.mean) + "," + shortest(f.largest) + "," +
                       std::to_string(f.negative) + "," + std::to_string(f.nonFinite) + ",";
    for (const double figure : {f.rmse, f.maxAbs, f.deltaEMean, f.deltaEMax, f.flip})
        text += shortest(figure) + ",";
    return text + (timing ? general(f.milliseconds, 4) + ",\n" : "\n");
}

Result<Sheet> Sheet::open(const std::string& path, const Study& study, bool timing)
{
    std::uint64_t failed = 0;
    Journal::Form form;
    form.head = sheetHead(study, timing);
    form.isOurs = [&](std::uint64_t cell, std::string_view line) {
        const std::string inputs = cell < cellCount(study) ? inputsOf(cellAt(study, cell)) : std::string("none");
        if (!line.starts_with(inputs))
            return false;
        failed += tellsFailure(line.substr(inputs.size())) ? 1U : 0U;
        return true;
    };
    form.foreign = "holds the figures of another study, or of this one before it was changed; choose another --out, or "
                   "remove the file";
    auto journal = Journal::open(path, form);
    if (!journal)
        return journal.error();
    return Sheet(*std::move(journal), failed);
}

Result<void> Sheet::append(const Cell& cell, const std::string& rest)
{
    if (auto written = journal_.append(inputsOf(cell) + rest); !written)
        return written;
    failed_ += tellsFailure(rest) ? 1U : 0U;
    return {};
}

} // namespace reflectance
