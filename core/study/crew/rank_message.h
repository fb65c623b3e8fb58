// What ranks say to each other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace reflectance {

struct RankMessage {
    enum class Kind : char {
        Hello = 'H',    ///< `hand` hands, process `serial`, on the host `text`; the first rank greets, too
        Job = 'J',      ///< for a hand
        Finished = 'F', ///< by a hand, as CrewEvent
        Died = 'D',
        Gone = 'G',
        Alive = 'A', ///< every second, both ways
        End = 'E'    ///< `hand` is 1 where every rank lives to hear it, so that all may part in order
    };
    Kind kind = Kind::Alive;
    std::size_t hand = 0; ///< of the rank
    std::uint64_t serial = 0;
    std::string text = {};
};

/// "J 3 17\ntext".
[[nodiscard]] std::string written(const RankMessage& message);
[[nodiscard]] std::optional<RankMessage> readRankMessage(std::string_view text);

/// Names this host, and the table of processes in which a process number means something.
[[nodiscard]] std::string hostHere();

/// What this process says of itself.
[[nodiscard]] RankMessage greeting(std::size_t hands);

/// The process that greeted, where it runs on this host, else 0.
[[nodiscard]] long processHere(const RankMessage& hello);

/// Whether a process of this host is no more; 0 never is.
[[nodiscard]] bool isNoMore(long process);

} // namespace reflectance
