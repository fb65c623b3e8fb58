// Recording and replaying in the window: what happens goes onto the tape, or comes from it, an event a frame.
#pragma once

#include "app/explorer/recording.h"
#include "core/base/result.h"

#include <deque>
#include <optional>
#include <string>

namespace reflectance::explorer {

struct Session;

struct Tape {
    std::optional<Recorder> recorder;
    std::string file;        ///< where the recording goes
    std::size_t written = 0; ///< events that are in the file
    std::deque<RecordedEvent> toPlay;
};

/// Brings the session to where the recording begins.
void loadTape(Session& session, const Recording& recording);

/// Starts recording from what is on screen.
void startRecording(Session& session, const std::string& file);

/// Does the next event, if any is left. One that does not fit ends the replay and says so.
void playTape(Session& session);

/// Call at the end of a frame: notes keys and what the hand did, and writes the file where it has grown.
void recordTape(Session& session, const std::vector<KeyPress>& keys, bool handIsBusy);

} // namespace reflectance::explorer
