#include "core/study/trade/trade_run.h"

#include "core/scene/requirements.h"
#include "core/study/cost/shading_cost.h"
#include "core/study/trade/rung.h"

#include <algorithm>

namespace reflectance {
namespace {

/// Timings before combinations are chosen: enough to order rungs by cost.
constexpr int firstRounds = 2;
/// Of the whole run, as it usually is.
constexpr double shareOfTruth = 0.08;

std::size_t lightsOf(const Scene& scene)
{
    return shiningLights(scene).size();
}

bool isWanted(const std::vector<std::string>& only, const Recipe& recipe)
{
    return only.empty() || std::find(only.begin(), only.end(), recipe.rungs.back()) != only.end();
}

} // namespace

TradeRun::TradeRun(const Scene& scene, const RenderSettings& settings, const TradeOptions& options, GlRenderer* gl)
    : scene_(scene), settings_(settings), options_(options), workshop_(scene.mesh, scene.camera, gl)
{
    trade_.model = modelOf(scene).id();
    trade_.mesh = scene.mesh->name;
    trade_.triangles = scene.mesh->triangles.size();
    trade_.lights = lightsOf(scene);
    trade_.settings = settings;
    trade_.machine = thisMachine(gl ? gl->description() : std::string());
    trade_.metric = options.metric;
    trade_.cost = options.cost;
    bare_ = bareRecipes(scene_, settings_, workshop_.hasGl());
    Singles singles = singleRungs(bare_);
    trade_.skipped = singles.skipped;
    waiting_ = bare_;
    bounds_.resize(bare_.size());
    if (bare_.size() > 3) // the half buffer is a rung as well, and the last of the bare recipes
        bounds_.back() = [&] {
            Recipe glsl = bare_[3];
            return applyRung(*findRung("half_buffer"), glsl).bound;
        }();
    for (std::size_t i = 0; i < singles.recipes.size(); ++i)
        if (isWanted(options_.only, singles.recipes[i])) {
            waiting_.push_back(std::move(singles.recipes[i]));
            bounds_.push_back(singles.bounds[i]);
        }
}

Result<bool> TradeRun::takeTruth(Progress* progress, double share)
{
    Image truth = Workshop::truth(scene_, settings_, progress, share * shareOfTruth);
    if (progress != nullptr && progress->cancel)
        return false;
    judge_.emplace(std::move(truth), gainOf(scene_.sensor));
    if (!judge_->seesObject())
        return Error{"no pixel shows the object, so there is nothing to measure; turn the camera towards it"};
    return true;
}

void TradeRun::noteChange(const Image& picture, Candidate& candidate)
{
    Image& base = basePictures_[candidate.recipe.onGl() ? 1 : 0];
    const bool isBase = candidate.recipe.rungs == std::vector<std::string>{candidate.recipe.onGl() ? "glsl" : "simd"};
    if (isBase)
        base = picture;
    if (const auto difference = compared(base, picture)) {
        candidate.change = difference->maxAbs;
        candidate.changeRmse = difference->rmse;
    }
}

Result<void> TradeRun::examine(const Recipe& recipe)
{
    auto prepared = workshop_.prepare(recipe);
    if (!prepared)
        return prepared.error();
    const auto picture = workshop_.picture(*prepared);
    if (!picture)
        return picture.error();
    Candidate candidate;
    candidate.recipe = recipe;
    candidate.error = judge_->errorOf(*picture);
    noteChange(*picture, candidate);
    candidate.lookMilliseconds = prepared->lookMilliseconds;
    candidate.shadings = prepared->shadings;
    candidate.bytes = prepared->bytes;
    if (stage_ == Stage::Singles)
        candidate.bound = bounds_[index_];
    const char* byItself = workshop_.hasGl() ? "glsl" : "double"; // as `render` chooses
    if (recipe.rungs == std::vector<std::string>{byItself})
        trade_.current = trade_.candidates.size();
    trade_.candidates.push_back(std::move(candidate));
    prepared_.push_back(*std::move(prepared));
    times_.emplace_back();
    return {};
}

Result<void> TradeRun::timeOne()
{
    const std::size_t i = index_ % prepared_.size();
    const auto time = workshop_.shadingTime(prepared_[i]);
    if (!time)
        return time.error();
    times_[i].push_back(*time);
    trade_.candidates[i].shade = timingOf(times_[i]);
    return {};
}

void TradeRun::measureKernel(Candidate& candidate) const
{
    const Recipe& recipe = candidate.recipe;
    const Model& model = modelOf(recipe.scene);
    if (recipe.onGl() || recipe.lobePerSample || model.text.usesTable)
        return;
    const RequiredModel required = requiredSurface(recipe.scene, recipe.arithmetic());
    candidate.kernelNs = shadingCost(required, recipe.arithmetic());
    candidate.kernelInstructions = shadingInstructions(required, recipe.arithmetic());
}

void TradeRun::next(Stage stage)
{
    stage_ = stage;
    index_ = 0;
}

void TradeRun::advance()
{
    if (stage_ == Stage::Singles && index_ >= waiting_.size())
        next(Stage::FirstTimings);
    if (stage_ == Stage::FirstTimings && index_ >= firstRounds * prepared_.size()) {
        const bool combine = options_.only.empty();
        waiting_ =
            combine ? compositions(bare_, trade_.candidates, options_.metric, options_.cost) : std::vector<Recipe>();
        next(Stage::Combinations);
    }
    if (stage_ == Stage::Combinations && index_ >= waiting_.size())
        next(Stage::Timings);
    if (stage_ == Stage::Timings && index_ >= static_cast<std::size_t>(options_.repetitions) * prepared_.size())
        next(Stage::Kernels);
    if (stage_ == Stage::Kernels && index_ >= trade_.candidates.size())
        next(Stage::Finished);
}

Result<bool> TradeRun::step(Progress* progress, double share)
{
    if (stage_ == Stage::Finished || (progress != nullptr && progress->cancel))
        return false;
    if (stage_ == Stage::Truth) {
        auto taken = takeTruth(progress, share);
        if (!taken || !*taken)
            return taken;
        next(Stage::Singles);
        return true;
    }
    Result<void> done;
    if (stage_ == Stage::Singles || stage_ == Stage::Combinations)
        done = examine(waiting_[index_]);
    else if (stage_ == Stage::FirstTimings || stage_ == Stage::Timings)
        done = timeOne();
    else
        measureKernel(trade_.candidates[index_]);
    if (!done)
        return done.error();
    ++index_;
    advance();
    markFront(trade_);
    return stage_ != Stage::Finished;
}

bool TradeRun::nextUsesGl() const
{
    if (stage_ == Stage::Singles || stage_ == Stage::Combinations)
        return waiting_[index_].onGl();
    if (stage_ == Stage::FirstTimings || stage_ == Stage::Timings)
        return prepared_[index_ % prepared_.size()].recipe.onGl();
    return false;
}

double TradeRun::done() const
{
    // Stages by their usual share of the time: how long those to come take is not known.
    constexpr double starts[] = {0.0, shareOfTruth, 0.3, 0.36, 0.65, 0.99, 1.0, 1.0};
    const std::size_t sizes[] = {1,
                                 waiting_.size(),
                                 firstRounds * prepared_.size(),
                                 waiting_.size(),
                                 static_cast<std::size_t>(options_.repetitions) * prepared_.size(),
                                 trade_.candidates.size(),
                                 1};
    const auto stage = static_cast<std::size_t>(stage_);
    const double within = static_cast<double>(index_) / static_cast<double>(std::max<std::size_t>(1, sizes[stage]));
    return starts[stage] + within * (starts[stage + 1] - starts[stage]);
}

Result<Trade> measuredTrade(const Scene& scene, const RenderSettings& settings, const TradeOptions& options,
                            GlRenderer* gl, Progress* progress, double share)
{
    TradeRun run(scene, settings, options, gl);
    for (;;) {
        const auto more = run.step(progress, share);
        if (!more)
            return more.error();
        if (progress != nullptr && progress->cancel)
            return Error{"stopped; nothing was written"};
        if (progress != nullptr)
            progress->done = share * run.done();
        if (!*more)
            return run.trade();
    }
}

} // namespace reflectance
