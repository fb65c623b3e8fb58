// The dial: an error that is good enough, or the time there is, turned into a way of drawing. Found on a small probe, verified
// on the whole picture.
#pragma once

#include "core/render/gl/gl_renderer.h"
#include "core/render/progress.h"
#include "core/study/trade/trade.h"

namespace reflectance {

struct DialWish {
    std::optional<double> tolerance;    ///< the cheapest within it is wanted
    std::optional<double> milliseconds; ///< else the most exact within them
    Metric metric = Metric::Max;
    Cost cost = Cost::Shading;
    int probeSide = 96; ///< pixels along the probe's longer side
};

/// Refuses what can never be met: an error below 0, a time of 0 or less, NaN, and both or neither at once.
[[nodiscard]] Result<void> checkWish(const DialWish& wish);

/// What the probe took for good, and the whole picture did not.
struct Missed {
    std::string name;
    double onProbe = 0.0, onPicture = 0.0; ///< errors
};

struct DialAnswer {
    std::optional<Candidate> chosen; ///< measured on the whole picture; nothing where no candidate meets the wish
    std::optional<Candidate> best;   ///< then: the most exact of all, or of a budget the cheapest
    std::vector<Missed> missed;
    std::size_t tried = 0, verified = 0; ///< candidates on the probe, and on the whole picture
};

/// For a tolerance: what is within it on the probe is verified by rising cost, then the rest by rising error, until one holds.
/// For a budget: of what the probe takes for about the most exact within it, the most exact on the whole picture.
[[nodiscard]] Result<DialAnswer> dialled(const Scene& scene, const RenderSettings& settings, const DialWish& wish,
                                         GlRenderer* gl, Progress* progress = nullptr);

/// The error of the same rungs on a changed scene, against that scene's own truth. GL's arithmetic is taken for SIMD's, whose
/// error it shares but for the last digits. Nothing where stopped, or where a rung no longer applies.
[[nodiscard]] std::optional<ErrorFigures> recheckedOn(const Scene& scene, const RenderSettings& settings,
                                                      const Recipe& chosen, Progress* progress = nullptr);

/// What was chosen, what it gives up, what the probe missed; or the best that can be had.
[[nodiscard]] std::vector<std::string> sentencesOf(const DialAnswer& answer, const DialWish& wish);

} // namespace reflectance
