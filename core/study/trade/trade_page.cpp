#include "core/study/trade/trade_page.h"

#include "core/base/text.h"
#include "core/study/trade/trade_chart.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr const char* style =
    "body{font:15px/1.5 Inter,system-ui,sans-serif;color:#222;max-width:1060px;margin:2rem auto;padding:0 1rem}"
    "h1{font-size:1.6rem;margin-bottom:.2rem}h2{font-size:1.15rem;margin-top:2rem}p.quiet,td.quiet{color:#666}"
    "table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums;width:100%}"
    "th,td{text-align:right;padding:.25rem .5rem;border-bottom:1px solid #e4e4e4}th:first-child,td:first-child"
    "{text-align:left}th{font-weight:600}tr.dominated td{color:#999}tr.chosen td{background:#eef5ea}"
    "svg{max-width:100%;height:auto}code{background:#f3f3f3;padding:.1rem .3rem;border-radius:3px}";

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

std::string paragraph(const std::string& text, const char* kind = "")
{
    return std::string("<p") + (*kind ? std::string(" class=\"") + kind + "\"" : "") + ">" + escaped(text) + "</p>\n";
}

std::string row(const std::vector<std::string>& cells, const char* tag, const char* kind = "")
{
    std::string text = std::string("<tr class=\"") + kind + "\">";
    for (const std::string& cell : cells)
        text += std::string("<") + tag + ">" + escaped(cell) + "</" + tag + ">";
    return text + "</tr>\n";
}

std::string number(double value)
{
    return general(value, 3);
}

std::vector<std::size_t> byCost(const Trade& trade)
{
    std::vector<std::size_t> order(trade.candidates.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return trade.candidates[a].cost(trade.cost) < trade.candidates[b].cost(trade.cost);
    });
    return order;
}

std::string tableOf(const Trade& trade, const std::optional<std::size_t>& choice)
{
    std::string text = "<table>\n" + row({"candidate", "max", "RMSE", "dE2000 p95", "dE2000 max", "FLIP", "ms again",
                                          "\u00B1", "ms first", "MB kept", "ns/shading", "instr."},
                                         "th");
    for (const std::size_t i : byCost(trade)) {
        const Candidate& c = trade.candidates[i];
        text +=
            row({nameOf(c.recipe), number(c.error.max), number(c.error.rmse), number(c.error.perceived.deltaEP95),
                 number(c.error.perceived.deltaEMax), number(c.error.perceived.flipMean), number(c.shade.median),
                 number(c.shade.spread), number(c.cost(Cost::FirstFrame)), number(static_cast<double>(c.bytes) / 1e6),
                 c.kernelNs ? number(*c.kernelNs) : "", c.kernelInstructions ? number(*c.kernelInstructions) : ""},
                "td",
                choice == i ? "chosen"
                : c.onFront ? ""
                            : "dominated");
    }
    return text + "</table>\n";
}

std::string sceneSentence(const Trade& trade)
{
    return trade.model + " on " + (trade.mesh.empty() ? "the mesh" : trade.mesh) + ", " +
           std::to_string(trade.triangles) + " triangles, " + std::to_string(trade.lights) +
           (trade.lights == 1 ? " light; " : " lights; ") + std::to_string(trade.settings.width) + "x" +
           std::to_string(trade.settings.height) + " pixels, " +
           std::to_string(trade.settings.samplesPerAxis * trade.settings.samplesPerAxis) + " samples each";
}

} // namespace

std::string sentenceOf(const Trade& trade, const Candidate& candidate)
{
    return nameOf(candidate.recipe) + ": " + number(candidate.error.by(trade.metric)) + " " +
           std::string(nameOf(trade.metric)) + ", " + number(candidate.cost(trade.cost)) + " ms +- " +
           number(candidate.shade.spread) + "; " + givenUp(candidate.recipe);
}

std::vector<std::string> findingsOf(const Trade& trade, const Wanted& wanted)
{
    std::vector<std::string> findings;
    if (wanted.anything()) {
        const std::string asked = wanted.tolerance ? number(*wanted.tolerance) : number(*wanted.milliseconds) + " ms";
        if (const auto choice = chosen(trade, wanted))
            findings.push_back((wanted.tolerance ? "Cheapest within " : "Most exact within ") + asked + ": " +
                               sentenceOf(trade, trade.candidates[*choice]) + ".");
        else if (const Candidate* best = wanted.tolerance ? mostExact(trade) : cheapest(trade))
            findings.push_back("Nothing is within " + asked + "; the best that can be had is " +
                               sentenceOf(trade, *best) + ".");
    }
    const std::vector<std::size_t> front = frontOf(trade);
    findings.push_back(std::to_string(front.size()) + " of " + std::to_string(trade.candidates.size()) +
                       " candidates are worth having: nothing else is at once cheaper and more exact.");
    if (const auto dominated = dominatedRungs(trade); !dominated.empty())
        findings.push_back("Never worth having here, alone or combined: " + joined(dominated) + ".");
    return findings;
}

std::string htmlOf(const Trade& trade, const Wanted& wanted, const std::string& command)
{
    std::string text =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>The trade, measured</title>"
        "<style>" +
        std::string(style) + "</style></head><body>\n<h1>The trade, measured</h1>\n" + paragraph(sceneSentence(trade)) +
        paragraph("Measured on " + sentenceOf(trade.machine), "quiet");
    text += svgOf(chartOf(trade, wanted.tolerance, true), 1040, 560);
    text += paragraph(
        "Every dot is a way of drawing this scene, held against the double picture with 64 samples per pixel. "
        "Bars are half the distance between the quartiles of the repeated times.",
        "quiet");
    text += "<h2>Findings</h2>\n";
    for (const std::string& finding : findingsOf(trade, wanted))
        text += paragraph(finding);
    if (!trade.skipped.empty()) {
        text += "<h2>Not tried</h2>\n<ul>\n";
        for (const SkippedRung& skipped : trade.skipped)
            text += "<li>" + escaped(skipped.rung + ": " + skipped.why) + "</li>\n";
        text += "</ul>\n";
    }
    text += "<h2>All candidates</h2>\n" + tableOf(trade, chosen(trade, wanted));
    text += paragraph(
        "max and RMSE are linear, white 1, over the whole picture; dE2000 over the pixels that the object covers, "
        "as a display shows them; FLIP at 67 pixels per degree. ms again: shading what is seen anew, as a dragged "
        "light does. ms first: the view's first picture, the mesh being in place. ns/shading: one evaluation of the "
        "model on the CPU, caches warm.",
        "quiet");
    return text + "<p class=\"quiet\">Made by <code>" + escaped(command) + "</code></p>\n</body></html>\n";
}

} // namespace reflectance
