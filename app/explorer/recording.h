// What a hand did, as JSON that does it again: keys, strokes in the picture, turns of the wheel, and edits of values. For
// tests and for reports of faults.
//
// The recorder replays what it has recorded beside the real thing. What the two do not agree on after a change is whole,
// be it a slider, a menu or a file that was opened, is recorded as an edit. So a replay ends where the session did, by
// construction, and needs no window.
#pragma once

#include "app/explorer/gestures.h"
#include "app/explorer/keys.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace reflectance::explorer {

/// From press to release; what lay between changes nothing.
struct RecordedStroke {
    MouseButton button = MouseButton::Left;
    Modifiers modifiers;
    ViewSize size;   ///< of the picture, pixels
    int handle = -1; ///< the light that was under the cursor
    int selected = -1;
    Cursor from, to;
    std::optional<Grasp> grasp = {}; ///< what the tool Grab took
};

/// A point of the object that was probed.
struct RecordedProbe {
    Cursor at;
    ViewSize size; ///< of the picture, pixels
};

struct RecordedWheel {
    double steps = 0.0;
};

struct RecordedEdit {
    std::string patch; ///< of the scene's JSON and what belongs to it (RFC 6902)
};

using RecordedEvent = std::variant<KeyPress, RecordedStroke, RecordedWheel, RecordedProbe, RecordedEdit>;

struct Recording {
    std::string start; ///< the document at the beginning, see documentOf
    std::vector<RecordedEvent> events;
};

/// What a recording is about: the scene, and whether and how it is compared, as JSON.
[[nodiscard]] std::string documentOf(const ExplorerState& state);

/// Does what the event did. An edit that does not fit the scene is an error.
[[nodiscard]] Result<void> replay(const RecordedEvent& event, ExplorerState& state);

/// The state in which a recording begins, and the one in which it ends.
[[nodiscard]] Result<ExplorerState> startOf(const Recording& recording);
[[nodiscard]] Result<ExplorerState> replayed(const Recording& recording);

[[nodiscard]] std::string recordingText(const Recording& recording);
[[nodiscard]] Result<Recording> parseRecording(std::string_view text, const std::string& file);
[[nodiscard]] Result<Recording> loadRecording(const std::string& path);

class Recorder {
public:
    explicit Recorder(const ExplorerState& state);

    void note(RecordedEvent event);
    /// Call when no hand is on anything: what the events so far do not explain becomes an edit.
    void settle(const ExplorerState& state);

    [[nodiscard]] const Recording& recording() const { return recording_; }

private:
    Recording recording_;
    ExplorerState shadow_; ///< where a replay is by now
};

} // namespace reflectance::explorer
