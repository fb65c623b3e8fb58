#include "core/study/crew/rank_message.h"

#include "core/base/text.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <unistd.h>

namespace reflectance {

std::string written(const RankMessage& message)
{
    return std::string(1, static_cast<char>(message.kind)) + " " + std::to_string(message.hand) + " " +
           std::to_string(message.serial) + "\n" + message.text;
}

std::optional<RankMessage> readRankMessage(std::string_view text)
{
    const std::size_t end = text.find('\n');
    const auto head = words(text.substr(0, end));
    if (end == std::string_view::npos || head.size() != 3 || head[0].size() != 1)
        return std::nullopt;
    const auto hand = parseInteger(head[1]);
    const auto serial = parseInteger(head[2]);
    if (!hand || !serial || *hand < 0 || *serial < 0)
        return std::nullopt;
    return RankMessage{static_cast<RankMessage::Kind>(head[0][0]), static_cast<std::size_t>(*hand),
                       static_cast<std::uint64_t>(*serial), std::string(text.substr(end + 1))};
}

std::string hostHere()
{
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    std::error_code unknown; // containers on one host may share its name
    return name.data() + std::string(" ") + std::filesystem::read_symlink("/proc/self/ns/pid", unknown).string();
}

RankMessage greeting(std::size_t hands)
{
    return {RankMessage::Kind::Hello, hands, static_cast<std::uint64_t>(::getpid()), hostHere()};
}

long processHere(const RankMessage& hello)
{
    return hello.text == hostHere() ? static_cast<long>(hello.serial) : 0;
}

bool isNoMore(long process)
{
    return process != 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

} // namespace reflectance
