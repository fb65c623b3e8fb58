// `extremes`: the hazards H01 to H74 in every arithmetic, and how far each model carries.
#include "core/study/extremes/extremes.h"
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/render/gl/gl_renderer.h"
#include "core/render/pictures/render_picture.h"
#include "core/study/extremes/sweep.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

namespace reflectance::cli {
namespace {

struct ExtremesOptions {
    std::string only;
    std::string context = "any";
    std::string json;
};

/// Neighbouring rows that say the same, printed as one: "float, simd".
template <class Row> struct Printed {
    Row row;
    std::vector<std::string> arithmetics;

    [[nodiscard]] std::string names() const { return arithmetics.size() == 4 ? "all four" : joined(arithmetics); }
};

template <class Row, class SaysTheSame>
std::vector<Printed<Row>> joinedRows(const std::vector<Row>& rows, const SaysTheSame& same)
{
    std::vector<Printed<Row>> printed;
    for (const Row& row : rows) {
        if (printed.empty() || !same(printed.back().row, row))
            printed.push_back({row, {}});
        printed.back().arithmetics.push_back(row.arithmetic);
    }
    return printed;
}

std::string headingOf(const Finding& f)
{
    return f.id + "  " + f.danger + ": " + f.input;
}

void printFindings(const std::vector<Finding>& findings)
{
    const auto same = [](const Finding& a, const Finding& b) {
        return headingOf(a) == headingOf(b) && a.found == b.found && a.verdict == b.verdict;
    };
    std::string heading;
    for (const auto& printed : joinedRows(findings, same)) {
        const Finding& f = printed.row;
        if (headingOf(f) != heading) {
            heading = headingOf(f);
            std::printf("%s\n     %-8s %-18s %s\n", heading.c_str(), "", "expected", f.expected.c_str());
        }
        std::printf("     %-8s %-18s %s\n", std::string(nameOf(f.verdict)).c_str(), printed.names().c_str(),
                    f.found.c_str());
    }
}

std::string pointText(const std::optional<double>& point, double last)
{
    return point ? general(*point, 3) : "not to " + general(last, 3);
}

void printSweep(const std::vector<SweepRow>& rows)
{
    const auto same = [](const SweepRow& a, const SweepRow& b) {
        return a.model == b.model && a.swept == b.swept && a.textbook == b.textbook && a.ours == b.ours;
    };
    std::puts("\nWhere three digits are lost first: a relative error above 1000 units of roundoff (2^-53, 2^-24), as a "
              "textbook\nwrites the model and as this program does. What remains here is the rounding of N, L and V.");
    std::printf("%-14s %-29s %-18s %12s %14s\n", "model", "swept", "", "textbook", "here");
    for (const auto& printed : joinedRows(rows, same)) {
        const SweepRow& row = printed.row;
        std::printf("%-14s %-29s %-18s %12s %14s\n", row.model.c_str(), row.swept.c_str(), printed.names().c_str(),
                    pointText(row.textbook, row.last).c_str(), pointText(row.ours, row.last).c_str());
    }
}

std::string summaryText(const ExtremesSummary& summary)
{
    std::string text = std::to_string(summary.passed) + " passed, " + std::to_string(summary.failed) + " failed";
    if (summary.notYet > 0)
        text += ", " + std::to_string(summary.notYet) + " not applicable yet (their models or parts do not exist)";
    if (summary.notRun > 0)
        text += ", " + std::to_string(summary.notRun) + " not run (no OpenGL context)";
    return text;
}

nlohmann::ordered_json described(const Finding& f)
{
    return {{"id", f.id},
            {"hazard", f.danger},
            {"precision", f.arithmetic},
            {"input", f.input},
            {"expected", f.expected},
            {"found", f.found},
            {"verdict", lowered(nameOf(f.verdict))}};
}

nlohmann::ordered_json described(const SweepRow& row)
{
    const auto point = [](const std::optional<double>& p) {
        return p ? nlohmann::ordered_json(*p) : nlohmann::ordered_json(nullptr);
    };
    return {{"model", row.model},
            {"swept", row.swept},
            {"precision", row.arithmetic},
            {"last", row.last},
            {"textbook", point(row.textbook)},
            {"ours", point(row.ours)}};
}

nlohmann::ordered_json described(const std::vector<Finding>& findings, const std::vector<SweepRow>& sweep)
{
    const ExtremesSummary summary = summaryOf(findings);
    nlohmann::ordered_json report{{"passed", summary.passed},
                                  {"failed", summary.failed},
                                  {"not_applicable_yet", summary.notYet},
                                  {"not_run", summary.notRun},
                                  {"findings", nlohmann::ordered_json::array()},
                                  {"three_digits_lost", nlohmann::ordered_json::array()}};
    for (const Finding& finding : findings)
        report["findings"].push_back(described(finding));
    for (const SweepRow& row : sweep)
        report["three_digits_lost"].push_back(described(row));
    return report;
}

int runAndReport(const ExtremesOptions& options, const Instruments& instruments)
{
    const std::vector<Finding> findings = runExtremes(instruments, options.only);
    if (findings.empty())
        return refused(Error{"there is no hazard '" + options.only + "'; choose one of: " + joined(hazardIds())});
    const std::vector<SweepRow> sweep = options.only.empty() ? sweepExtremes(instruments) : std::vector<SweepRow>();
    const ExtremesSummary summary = summaryOf(findings);
    if (options.json != "-") {
        printFindings(findings);
        if (!sweep.empty())
            printSweep(sweep);
        std::printf("\n%s\n", summaryText(summary).c_str());
    }
    const auto written = writeReport(options.json, described(findings, sweep));
    if (!written)
        return refused(written.error());
    return summary.failed == 0 ? Done : DoesNotHold;
}

int runExtremesVerb(const ExtremesOptions& options)
{
    const auto context = openHeadless(contextNamed(options.context));
    std::optional<GlRenderer> gl;
    std::string whyNot = context ? "" : context.error().message;
    if (context) {
        if (auto renderer = GlRenderer::create((*context)->loader()))
            gl = *std::move(renderer);
        else
            whyNot = renderer.error().message;
    }
    if (!gl)
        std::cerr << "reflectance: the glsl rows are not run and do not count: " << whyNot << '\n';
    return runAndReport(options, programInstruments(gl ? &*gl : nullptr, whyNot));
}

} // namespace

void addExtremes(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<ExtremesOptions>();
    CLI::App* verb = program.add_subcommand(
        "extremes",
        "The hazards at which reflectance code breaks, H01 to H74: case, expected, found, verdict, in every "
        "arithmetic; and the first exponent, angle or length at which each model loses three digits. Exit 1 "
        "if an applicable row fails");
    verb->add_option("--only", options->only, "one hazard: H04");
    verb->add_option("--context", options->context, "for glsl: any, osmesa or egl")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
    verb->add_option("--json", options->json, "figures, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = runExtremesVerb(*options); });
}

} // namespace reflectance::cli
