#include "core/study/goniometer/groove_study.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/study/goniometer/lobe_charts.h"

namespace reflectance {
namespace {

constexpr int manyBounces = 10;

const Model& modelNamed(std::string_view id)
{
    return **findModel(id);
}

ParameterValues rough(double rho, double sigma)
{
    return {{"rho", {rho, rho, rho}}, {"sigma", {radians(sigma)}}};
}

FactorFunction formula(std::string_view id, double rho, double sigma)
{
    const Model& model = modelNamed(id);
    return factorOf(model, flatValues(model.text, rough(rho, sigma)));
}

FactorFunction firstTerm(double rho, double sigma)
{
    return onceReflected(modelNamed("oren_nayar_full"), rough(rho, sigma), rho);
}

LabRun traced(const MicroSurface& surface, double rho, int bounces, std::size_t thetas, const LabTargets& targets,
              Progress* progress)
{
    const Model& lambert = modelNamed("lambert");
    LabSetup setup;
    setup.surface = surface.text;
    setup.values = flatValues(lambert.text, {{"kd", {rho}}});
    setup.effects.bounces = bounces;
    setup.shape = labShape(thetas, thetas, true);
    const MicroTracer tracer(surface, {&lambert, setup.values, 1}, setup.effects);
    LabRun run = startedRun(std::move(setup), surface.fingerprint());
    Progress own;
    const auto watch = [&](const LabRun&) { own.cancel = progress && progress->cancel; };
    measure(run, tracer, targets, &own, watch);
    return run;
}

std::string percent(double share)
{
    return general(100.0 * share, 3) + " %";
}

std::string row(const StudiedGrooves& g)
{
    std::string text = "| " + general(g.sigma, 3);
    for (const FormulaGap* gap : {&g.onceAgainstLambert, &g.onceAgainstFirst, &g.onceAgainstSimple, &g.twiceAgainstFull,
                                  &g.oftenAgainstFull, &g.oftenAgainstSimple})
        text += " | " + percent(gap->rms) + " (" + (gap->mean < 0.0 ? "" : "+") + percent(gap->mean) + ")";
    return text + " | " + percent(g.oftenAgainstFull.noise) + " |\n";
}

} // namespace

Result<GrooveStudy> studyGrooves(const std::vector<double>& sigmas, double rho, std::size_t thetas,
                                 const LabTargets& targets, Progress* progress)
{
    GrooveStudy study{rho, targets, {}};
    for (const double sigma : sigmas) {
        const auto surface = microSurface("vgrooves:sigma=" + shortest(sigma));
        if (!surface)
            return surface.error();
        StudiedGrooves g;
        g.sigma = sigma;
        double steps = 0.0;
        for (auto& [run, bounces] : {std::pair{&g.once, 0}, {&g.twice, 1}, {&g.often, manyBounces}}) {
            *run = traced(*surface, rho, bounces, thetas, targets, progress);
            if (progress && progress->cancel)
                return Error{"stopped; nothing was written"};
            steps += 1.0;
            if (progress)
                progress->done =
                    (static_cast<double>(study.grooves.size()) + steps / 3.0) / static_cast<double>(sigmas.size());
        }
        const Model& lambert = modelNamed("lambert");
        g.onceAgainstLambert = gapBetween(g.once, factorOf(lambert, flatValues(lambert.text, {{"kd", {rho}}})));
        g.onceAgainstFirst = gapBetween(g.once, firstTerm(rho, sigma));
        g.twiceAgainstFull = gapBetween(g.twice, formula("oren_nayar_full", rho, sigma));
        g.oftenAgainstFull = gapBetween(g.often, formula("oren_nayar_full", rho, sigma));
        g.onceAgainstSimple = gapBetween(g.once, formula("oren_nayar", rho, sigma));
        g.oftenAgainstSimple = gapBetween(g.often, formula("oren_nayar", rho, sigma));
        study.grooves.push_back(std::move(g));
    }
    return study;
}

std::vector<Drawing> drawingsOf(const GrooveStudy& study)
{
    std::vector<Drawing> drawings;
    for (const StudiedGrooves& g : study.grooves) {
        const std::size_t incidence = nearestIncidence(g.once.setup, radians(60.0));
        Chart chart = planeChart(g.often, "traced, up to 10 interreflections", incidence,
                                 {{"Oren-Nayar, full", formula("oren_nayar_full", study.rho, g.sigma)},
                                  {"Oren-Nayar, full, first term", firstTerm(study.rho, g.sigma)},
                                  {"Oren-Nayar, A/B", formula("oren_nayar", study.rho, g.sigma)}});
        chart.series.push_back(tracedSeries(g.once, "traced, single reflection", incidence, seriesColor(5)));
        chart.title += ", sigma " + general(g.sigma, 3) + " degrees, rho " + general(study.rho, 3);
        drawings.push_back({"sigma" + general(g.sigma, 3),
                            "Grooves with sigma " + general(g.sigma, 3) + " degrees in the plane of incidence", chart});
    }
    return drawings;
}

std::string pageOf(const GrooveStudy& study, const std::string& images, const std::string& command)
{
    std::string text =
        "# Oren and Nayar's formula, traced\n\n"
        "Grooves of Lambert facets with albedo " +
        general(study.rho, 3) +
        ", in all directions, their slopes spread as in Oren and Nayar's derivation (SIGGRAPH 1994), traced in the "
        "[virtual goniometer](goniometer.md). This page was written by\n\n    " +
        command +
        "\n\nThe gap is formula minus traced: the root mean square of f over all cells of the table, weighted with "
        "both cosines "
        "and solid angles, over that of f; in parentheses the mean, what the formula has too much. *Once*: single "
        "reflection. "
        "*Twice*: one interreflection. *Often*: up to " +
        std::to_string(manyBounces) +
        ". L1 is the part of the full formula "
        "that is linear in the albedo, A/B its short form. *Noise* is what the cells' standard errors alone make of "
        "such a "
        "number.\n\n"
        "| sigma | once, Lambert | once, L1 | once, A/B | twice, full | often, full | often, A/B | noise |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const StudiedGrooves& g : study.grooves)
        text += row(g);
    for (const Drawing& drawing : drawingsOf(study))
        text += "\n![" + drawing.says + "](" + images + drawing.name + ".svg)\n";
    return text;
}

} // namespace reflectance
