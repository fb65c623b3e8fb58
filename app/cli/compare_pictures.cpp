#include "app/cli/compare_pictures.h"

#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/image/compare.h"
#include "core/image/perceived.h"
#include "core/image/picture_file.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace reflectance::cli {
namespace {

struct Pair {
    Picture a, b;
    [[nodiscard]] bool isLinear() const { return a.isLinear() && b.isLinear(); }
};

constexpr const char* channelNames[] = {"red", "green", "blue"};

void printTable(const Pair& pair, const Comparison& c, const PerceivedDifference& seen)
{
    const auto row = [](const char* name, double value) { std::printf("%-28s %.6g\n", name, value); };
    std::printf("%-28s %d x %d\n", "size", pair.a.image.width, pair.a.image.height);
    std::printf("%-28s %s\n", "values", pair.isLinear() ? "linear" : "linear, decoded from 8- or 16-bit codes");
    if (c.identical)
        std::printf("%-28s %s\n", "identical", "yes, bit for bit");
    else if (c.maxAbs > 0.0)
        std::printf("%-28s %.6g   (column %d, row %d, %s)\n", "max abs", c.maxAbs, c.x, c.y, channelNames[c.channel]);
    else
        std::printf("%-28s %s\n", "max abs", "0   (only signs of zero or NaN payloads differ)");
    row("RMSE", c.rmse);
    row("mean abs", c.meanAbs);
    row(("max relative (floor " + shortest(relativeFloor) + ")").c_str(), c.maxRelative);
    row("dE2000 mean", seen.deltaEMean);
    row("dE2000 95th percentile", seen.deltaEP95);
    row("dE2000 max", seen.deltaEMax);
    row("FLIP mean", seen.flipMean);
    std::printf("%-28s %zu of %zu\n", "pixels that differ", c.differing, pair.a.image.pixels());
    std::printf("%-28s %zu and %zu\n", "negative pixels", c.a.negative, c.b.negative);
    std::printf("%-28s %zu and %zu\n", "non-finite pixels", c.a.nonFinite, c.b.nonFinite);
}

/// Infinite figures become null: JSON has no infinity.
nlohmann::ordered_json described(const Pair& pair, const Comparison& c, const PerceivedDifference& seen)
{
    const auto odd = [](const OddPixels& p) {
        return nlohmann::ordered_json{{"negative", p.negative}, {"non_finite", p.nonFinite}};
    };
    return {{"width", pair.a.image.width},
            {"height", pair.a.image.height},
            {"linear", pair.isLinear()},
            {"identical", c.identical},
            {"max_abs", c.maxAbs},
            {"max_at", {{"column", c.x}, {"row", c.y}, {"channel", channelNames[c.channel]}}},
            {"rmse", c.rmse},
            {"mean_abs", c.meanAbs},
            {"max_relative", c.maxRelative},
            {"relative_floor", relativeFloor},
            {"de2000_mean", seen.deltaEMean},
            {"de2000_p95", seen.deltaEP95},
            {"de2000_max", seen.deltaEMax},
            {"flip_mean", seen.flipMean},
            {"differing_pixels", c.differing},
            {"a", odd(c.a)},
            {"b", odd(c.b)}};
}

Result<void> writeMap(const Pair& pair, const Comparison& c, const CompareOptions& options)
{
    if (options.diff.empty())
        return {};
    const double largest = c.maxAbs > 0.0 && std::isfinite(c.maxAbs) ? c.maxAbs : 1.0;
    const double scale = options.threshold.value_or(0.0) > 0.0 ? *options.threshold : largest;
    const auto map = differenceMap(pair.a.image, pair.b.image, scale);
    auto written = writePng(options.diff, pair.a.image.width, pair.a.image.height, map);
    if (written)
        std::fprintf(stderr, "%s: full blue is -%s, full red +%s in luminance (second minus first)\n",
                     options.diff.c_str(), general(scale, 4).c_str(), general(scale, 4).c_str());
    return written;
}

} // namespace

int comparePictures(const std::string& a, const std::string& b, const CompareOptions& options)
{
    auto first = readPicture(a);
    if (!first)
        return refused(first.error());
    auto second = readPicture(b);
    if (!second)
        return refused(second.error());
    const Pair pair{*std::move(first), *std::move(second)};
    const auto comparison = compared(pair.a.image, pair.b.image);
    if (!comparison)
        return refused(comparison.error());
    if (const auto written = writeMap(pair, *comparison, options); !written)
        return refused(written.error());
    const PerceivedDifference seen = PerceivedReference(pair.a.image).to(pair.b.image);
    if (options.json != "-")
        printTable(pair, *comparison, seen);
    if (const auto written = writeReport(options.json, described(pair, *comparison, seen)); !written)
        return refused(written.error());
    return comparison->maxAbs <= options.threshold.value_or(HUGE_VAL) ? Done : DoesNotHold;
}

} // namespace reflectance::cli
