// Undo and redo. The loop shows the history every frame; what has changed since the last step, once the hand is off it,
// is one step more: a drag of a slider or of a light, one key, one file opened. Nothing has to be announced.
//
// A step holds the whole scene as a value; meshes, tables and pictures are shared between the steps, so that one costs
// a few kilobytes. What is held is bounded in number and in bytes; the oldest steps go first.
#pragma once

#include "app/explorer/changes.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <string>

namespace reflectance::explorer {

struct ExplorerState;

/// What keeps a change from being whole yet.
struct Hand {
    bool busy = false;    ///< a control or the picture is held
    bool turning = false; ///< the turntable moves the camera
    bool loading = false; ///< a file is being read
};

struct HistoryStep {
    std::string name; ///< of what led to it
    Moment after;
    int selectedLight = 0;
    int tourStep = 0; ///< 0 outside the tour
};

class History {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::size_t mostSteps = 200;
    static constexpr std::chrono::milliseconds zoomPause{800}; ///< turns of the wheel within it are one step

    /// `mostBytes` bounds the meshes and pictures that steps hold.
    explicit History(std::size_t mostBytes = std::size_t{1} << 30U) : mostBytes_(mostBytes) {}

    /// Notes what has changed, if it is whole. The first call notes where it all begins.
    void watch(const ExplorerState& state, Hand hand, Time now);

    [[nodiscard]] bool canUndo() const { return here_ > 0; }
    [[nodiscard]] bool canRedo() const { return here_ + 1 < steps_.size(); }
    /// The name of what undo would take back; empty where there is nothing.
    [[nodiscard]] std::string undoName() const;
    [[nodiscard]] std::string redoName() const;

    /// Brings one state of the list back; one that is not there changes nothing. What was not whole yet becomes a step
    /// of its own first, so that it is not lost.
    void undo(ExplorerState& state);
    void redo(ExplorerState& state);
    void go(std::size_t step, ExplorerState& state);

    /// The states from the oldest that is kept; the first one's name says where it all began.
    [[nodiscard]] const std::deque<HistoryStep>& steps() const { return steps_; }
    [[nodiscard]] std::size_t here() const { return here_; }
    [[nodiscard]] std::size_t heldBytes() const; ///< of meshes and pictures, each counted once

private:
    void push(const ExplorerState& state, Moment moment, Time now);
    [[nodiscard]] bool continuesZoom(const Moment& moment, Time now) const;
    void show(ExplorerState& state);

    std::size_t mostBytes_;
    std::deque<HistoryStep> steps_;
    std::size_t here_ = 0; ///< index into steps_; what is on screen but for an unfinished change
    std::optional<Time> lastZoom_;
};

} // namespace reflectance::explorer
