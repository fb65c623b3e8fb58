#include "app/explorer/tape.h"

#include "app/explorer/session.h"
#include "core/base/file.h"

#include <utility>

namespace reflectance::explorer {

void loadTape(Session& session, const Recording& recording)
{
    Result<ExplorerState> start = startOf(recording);
    if (!start) {
        session.state.message = Message{start.error().sentence(), true};
        return;
    }
    session.state.scene = std::move(start->scene);
    session.state.compare = start->compare;
    session.state.selectedLight = start->selectedLight;
    session.tape.toPlay.assign(recording.events.begin(), recording.events.end());
}

void startRecording(Session& session, const std::string& file)
{
    session.tape.recorder.emplace(session.state);
    session.tape.file = file;
}

void playTape(Session& session)
{
    std::deque<RecordedEvent>& toPlay = session.tape.toPlay;
    if (toPlay.empty())
        return;
    const RecordedEvent event = std::move(toPlay.front());
    toPlay.pop_front();
    if (const Result<void> done = replay(event, session.state); !done) {
        toPlay.clear();
        session.state.message = Message{"The replay stopped: " + done.error().sentence(), true};
    } else if (toPlay.empty()) {
        session.state.message = Message{"The replay has ended.", false};
    }
}

void recordTape(Session& session, const std::vector<KeyPress>& keys, bool handIsBusy)
{
    std::vector<RecordedEvent> done = std::exchange(session.viewport.done, {});
    Tape& tape = session.tape;
    if (!tape.recorder)
        return;
    for (const KeyPress& key : keys)
        tape.recorder->note(key);
    for (RecordedEvent& event : done)
        tape.recorder->note(std::move(event));
    if (!handIsBusy)
        tape.recorder->settle(session.state);
    const std::size_t events = tape.recorder->recording().events.size();
    if (events == tape.written)
        return;
    tape.written = events;
    if (const Result<void> saved = writeAtomically(tape.file, recordingText(tape.recorder->recording())); !saved)
        session.state.message = Message{"The recording cannot be written: " + saved.error().sentence(), true};
}

} // namespace reflectance::explorer
