// Messages between ranks. Nothing here waits for another rank, which may have died.
#pragma once

#include <optional>
#include <string>

namespace reflectance {

class RankLink {
public:
    struct Message {
        int from = 0;
        std::string text = {};
    };

    RankLink() = default;
    virtual ~RankLink() = default;
    RankLink(const RankLink&) = delete;
    RankLink& operator=(const RankLink&) = delete;

    [[nodiscard]] virtual int size() const = 0; ///< ranks 0 .. size() - 1, this one among them

    /// Puts a message on its way. Those to one rank arrive in order, or not at all.
    virtual void send(int to, std::string text) = 0;
    /// The next message that is there whole.
    [[nodiscard]] virtual std::optional<Message> receive() = 0;
    /// Moves what is on its way; whether all of it has left.
    virtual bool flush() = 0;
    /// Only where every rank does so, for it waits for all of them; without it the process may just end.
    virtual void finish() = 0;
};

} // namespace reflectance
