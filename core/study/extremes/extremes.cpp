#include "core/study/extremes/extremes.h"

#include "core/base/text.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <iterator>

namespace reflectance {
namespace {

/// All rows, in the order of their ids.
const Hazards& hazards()
{
    static const Hazards all = [] {
        Hazards rows;
        for (const auto theme : {lobeHazards, highlightHazards, vectorHazards, meshHazards, pictureHazards,
                                 matrixHazards, roughHazards, lightHazards, sensorHazards, arithmeticHazards})
            std::ranges::move(theme(), std::back_inserter(rows));
        std::ranges::stable_sort(rows, {}, &Hazard::id);
        return rows;
    }();
    return all;
}

std::string absentModel(const Hazard& hazard, const Instruments& instruments)
{
    const Bench bench(instruments, Precision::Double);
    for (const std::string& id : hazard.models)
        if (!bench.find(id))
            return id;
    return {};
}

Finding begun(const Hazard& hazard, std::string arithmetic)
{
    return {static_cast<std::size_t>(&hazard - hazards().data()),
            hazard.id,
            hazard.danger,
            std::move(arithmetic),
            hazard.input,
            hazard.expected,
            {},
            Verdict::NotYet};
}

Finding finding(const Hazard& hazard, const Instruments& instruments, Precision precision, std::string arithmetic)
{
    Finding row = begun(hazard, std::move(arithmetic));
    if (precision == Precision::Glsl && !instruments.whyNoGlsl.empty()) {
        row.verdict = Verdict::NotRun;
        row.found = instruments.whyNoGlsl;
        return row;
    }
    Bench bench(instruments, precision);
    Outcome outcome = hazard.check(bench);
    row.verdict = outcome.holds && !bench.problem() ? Verdict::Pass : Verdict::Fail;
    row.found = bench.problem() ? bench.problem()->sentence() : std::move(outcome.found);
    return row;
}

void run(const Hazard& hazard, const Instruments& instruments, std::vector<Finding>& findings)
{
    const std::string model = absentModel(hazard, instruments);
    if (!hazard.missing.empty() || !model.empty()) {
        findings.push_back(begun(hazard, "-"));
        findings.back().found =
            "not applicable yet: there is no " + (hazard.missing.empty() ? "model '" + model + "'" : hazard.missing);
        return;
    }
    if (hazard.precisions.empty())
        findings.push_back(finding(hazard, instruments, Precision::Double, "-"));
    for (const Precision precision : hazard.precisions)
        findings.push_back(finding(hazard, instruments, precision, std::string(nameOf(precision))));
}

} // namespace

std::string_view nameOf(Verdict verdict)
{
    constexpr std::string_view names[] = {"pass", "FAIL", "not yet", "not run"};
    return names[static_cast<int>(verdict)];
}

std::vector<Finding> runExtremes(const Instruments& instruments, std::string_view only)
{
    std::vector<Finding> findings;
    for (const Hazard& hazard : hazards())
        if (only.empty() || hazard.id == only)
            run(hazard, instruments, findings);
    return findings;
}

Exhibit exhibitOf(const Finding& finding)
{
    const Hazard& hazard = hazards().at(finding.hazard);
    return hazard.show ? hazard.show() : Exhibit{std::nullopt, "There is no picture of this case."};
}

std::vector<std::string> hazardIds()
{
    std::vector<std::string> ids;
    for (const Hazard& hazard : hazards())
        if (ids.empty() || ids.back() != hazard.id)
            ids.push_back(hazard.id);
    return ids;
}

ExtremesSummary summaryOf(const std::vector<Finding>& findings)
{
    const auto count = [&](Verdict verdict) {
        return static_cast<std::size_t>(std::ranges::count(findings, verdict, &Finding::verdict));
    };
    return {count(Verdict::Pass), count(Verdict::Fail), count(Verdict::NotYet), count(Verdict::NotRun)};
}

} // namespace reflectance
