// Keeps the session against crashes: a changed scene is in a file of the state folder within two seconds, and what an
// earlier program that did not end left there is offered again.
//
// The policy, by which no session is ever lost silently:
// - The file goes when the program ends by the user's will, or when the scene has been saved. Nothing else removes it.
// - An earlier session stays until it is dismissed and the program then ends by the user's will, too.
// - Restoring one trades places: its file becomes this program's, and what was on screen becomes an earlier session.
// - Programs that run together have a file each (session_slot.h) and never offer one another's.
#pragma once

#include "app/explorer/session_slot.h"
#include "app/explorer/state.h"

#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

class Autosave {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds pause{2}; ///< from a change to its writing

    /// Takes over what earlier programs left in `folder`; without one (empty) nothing is kept.
    explicit Autosave(std::filesystem::path folder);

    /// The scene needs no keeping: it has been saved, or nothing has been done to it yet.
    void settle(const Scene& scene);

    /// Call with every frame. Writes a changed scene on another thread once `pause` has passed.
    void watch(const Scene& scene, Clock::time_point now);

    /// Until watch() has something to do; infinity if there is nothing to keep.
    [[nodiscard]] double secondsUntilWrite(Clock::time_point now) const;

    void finishWriting(); ///< waits for what is being written

    /// Why the session cannot be kept, once until it can be again.
    [[nodiscard]] std::optional<Error> takeProblem();

    /// Earlier sessions, newest first.
    [[nodiscard]] std::vector<EarlierSession> earlier() const;
    [[nodiscard]] bool offers(const std::string& file) const; ///< whether it is one of them
    void dismiss(const std::string& file);

    /// The earlier session has been read: `restored` takes the place of the scene on screen, `replaced`.
    void adopt(const std::string& file, const Scene& replaced, const Scene& restored);

    /// The program ends by the user's will: its file and the dismissed ones go.
    void end();

private:
    struct Earlier {
        SessionSlot slot;
        EarlierSession session;
    };

    [[nodiscard]] std::vector<Earlier>::iterator find(const std::string& file);
    void write(const Scene& scene);
    void note(const Result<void>& written);

    std::filesystem::path folder_;
    std::vector<Earlier> earlier_;
    std::optional<SessionSlot> own_; ///< from the first writing on
    std::optional<Scene> seen_;
    std::optional<Clock::time_point> due_;
    std::future<Result<void>> writing_;
    std::optional<Error> problem_;
    bool failing_ = false; ///< the problem has been told
};

/// "mug, hybrid, 2 lights" of a scene file's text; empty where it cannot be read.
[[nodiscard]] std::string sessionContent(const std::string& text);

/// "just now", "5 minutes ago", "3 hours ago", "2 days ago".
[[nodiscard]] std::string ago(std::chrono::seconds age);

} // namespace reflectance::explorer
