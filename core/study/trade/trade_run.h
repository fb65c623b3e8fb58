// Measures a trade step by step, so that whoever runs it can draw between steps, show what is there, and stop.
#pragma once

#include "core/study/trade/compose.h"
#include "core/study/trade/workshop.h"

namespace reflectance {

struct TradeOptions {
    Metric metric = Metric::Max;
    Cost cost = Cost::Shading;
    int repetitions = 7;                ///< timings of each candidate, interleaved: one of each in every round
    std::vector<std::string> only = {}; ///< rungs to try besides the arithmetics; empty: all
};

class TradeRun {
public:
    /// `gl`: its context must be current at every step that nextUsesGl() announces; null: CPU only.
    TradeRun(const Scene& scene, const RenderSettings& settings, const TradeOptions& options, GlRenderer* gl);

    /// Does the next piece of work: the truth (which may take seconds), else some ten milliseconds. False where there is
    /// nothing left. An Error ends the run: no visible pixel, or a picture that GL refuses.
    /// The truth counts `share` times its part in the progress.
    [[nodiscard]] Result<bool> step(Progress* progress = nullptr, double share = 1.0);

    [[nodiscard]] bool nextUsesGl() const;
    [[nodiscard]] double done() const; ///< share, 0 .. 1

    /// What is known so far; candidates without a timing yet stand at its end.
    [[nodiscard]] const Trade& trade() const { return trade_; }
    [[nodiscard]] const Judge* judge() const { return judge_ ? &*judge_ : nullptr; }
    [[nodiscard]] Workshop& workshop() { return workshop_; }

private:
    enum class Stage { Truth, Singles, FirstTimings, Combinations, Timings, Kernels, Finished };

    [[nodiscard]] Result<bool> takeTruth(Progress* progress, double share);
    [[nodiscard]] Result<void> examine(const Recipe& recipe);
    [[nodiscard]] Result<void> timeOne();
    void measureKernel(Candidate& candidate) const;
    void noteChange(const Image& picture, Candidate& candidate);
    void next(Stage stage);
    /// Where a stage is done, the next one that has work.
    void advance();

    Scene scene_;
    RenderSettings settings_;
    TradeOptions options_;
    Workshop workshop_;
    std::optional<Judge> judge_;
    Trade trade_;
    std::vector<Recipe> bare_;
    std::vector<Recipe> waiting_;               ///< to be examined in this stage
    std::vector<std::optional<double>> bounds_; ///< of what waits; none promised beyond its end
    std::vector<Prepared> prepared_;            ///< of each candidate
    std::vector<std::vector<double>> times_;    ///< of each candidate
    Image basePictures_[2];                     ///< CPU, GL: without rungs
    Stage stage_ = Stage::Truth;
    std::size_t index_ = 0; ///< in this stage
};

/// All steps; watched and stopped by `progress`, of which they are a share. An Error then says that it was stopped.
[[nodiscard]] Result<Trade> measuredTrade(const Scene& scene, const RenderSettings& settings,
                                          const TradeOptions& options, GlRenderer* gl, Progress* progress = nullptr,
                                          double share = 1.0);

} // namespace reflectance
