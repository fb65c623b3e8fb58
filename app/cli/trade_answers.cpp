#include "app/cli/trade_answers.h"

#include "app/cli/long_work.h"
#include "app/cli/report.h"
#include "app/cli/trade_report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/image/picture_file.h"
#include "core/study/trade/sufficient.h"
#include "core/study/trade/terms.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

using Json = nlohmann::ordered_json;

int stopped()
{
    return refused(Error{"stopped; nothing was written"}, Stopped);
}

int written(const std::string& json, const Json& report, int exitCode = Done)
{
    const auto done = writeReport(json, report);
    return done ? exitCode : refused(done.error());
}

Json described(const DialAnswer& answer)
{
    Json missed = Json::array();
    for (const Missed& m : answer.missed)
        missed.push_back({{"name", m.name}, {"error_on_probe", m.onProbe}, {"error_on_picture", m.onPicture}});
    return {{"chosen", answer.chosen ? cli::described(*answer.chosen) : Json(nullptr)},
            {"best", answer.best ? cli::described(*answer.best) : Json(nullptr)},
            {"tried", answer.tried},
            {"verified", answer.verified},
            {"missed_by_probe", missed}};
}

std::string colorText(ChartColor color)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(color & 0xFFFFFFU));
    return text;
}

} // namespace

int answerDial(const Scene& scene, const RenderSettings& settings, const DialWish& wish, GlRenderer* gl,
               const std::string& json)
{
    const auto answer = [&] {
        const LongWork work;
        return dialled(scene, settings, wish, gl, &LongWork::progress());
    }();
    if (!answer)
        return refused(answer.error(), LongWork::wasStopped() ? Stopped : BadInput);
    if (json != "-")
        for (const std::string& sentence : sentencesOf(*answer, wish))
            std::printf("%s\n", sentence.c_str());
    return written(json, described(*answer), answer->chosen ? Done : DoesNotHold);
}

int answerMap(const Scene& scene, const RenderSettings& settings, double tolerance, Metric metric,
              const std::string& file, const std::string& json)
{
    const auto map = [&] {
        const LongWork work;
        return sufficientModels(scene, settings, tolerance, metric, &LongWork::progress());
    }();
    if (!map)
        return stopped();
    if (const auto done = writePng(file, map->width, map->height, painted(*map)); !done)
        return refused(done.error());
    Json models = Json::array();
    for (const SufficientModel& model : map->models) {
        const std::string name = nameOf(model.recipe);
        if (json != "-")
            std::printf("%s %8zu pixels  %6.3g ns  %s\n", colorText(model.color).c_str(), model.pixels,
                        model.nanoseconds, name.c_str());
        models.push_back({{"surface", name},
                          {"color", colorText(model.color)},
                          {"pixels", model.pixels},
                          {"ns_per_shading", model.nanoseconds}});
    }
    return written(json, {{"tolerance", tolerance}, {"metric", nameOf(metric)}, {"models", models}});
}

int answerTerms(const Scene& scene, const RenderSettings& settings, int repetitions, const std::string& json)
{
    const auto bars = [&] {
        const LongWork work;
        return termBars(scene, settings, repetitions, &LongWork::progress());
    }();
    if (!bars)
        return stopped();
    if (json != "-")
        std::printf("%-20s %10s %10s %10s %10s %10s\n", "without", "dE p95", "dE max", "RMSE", "saves ms", "+-");
    Json terms = Json::array();
    for (const TermFigures& term : bars->terms) {
        if (json != "-")
            std::printf("%-20s %10.3g %10.3g %10.3g %10.3g %10.2g\n", term.name.c_str(), term.buys.perceived.deltaEP95,
                        term.buys.perceived.deltaEMax, term.buys.rmse, term.milliseconds, term.spread);
        terms.push_back({{"term", term.name},
                         {"de_p95", term.buys.perceived.deltaEP95},
                         {"de_max", term.buys.perceived.deltaEMax},
                         {"rmse", term.buys.rmse},
                         {"max", term.buys.max},
                         {"saves_ms", term.milliseconds},
                         {"saves_ms_spread", term.spread}});
    }
    if (json != "-")
        std::printf("%-20s %42s %10.3g %10.2g\n", "all terms cost", "", bars->whole.median, bars->whole.spread);
    return written(json, {{"whole_ms", bars->whole.median}, {"whole_ms_spread", bars->whole.spread}, {"terms", terms}});
}

} // namespace reflectance::cli
