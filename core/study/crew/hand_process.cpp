#include "core/study/crew/hand_process.h"

#include "core/base/check.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace reflectance {
namespace {

/// What worker and keeper share: the serial of the job in hand, 0 for none. It is written before a job leaves the socket and
/// after its result is sent, so that none is lost between the two.
using InHand = std::atomic<std::uint64_t>;

/// Serial, kind, text, as one packet.
std::string packed(std::uint64_t serial, CrewEvent::Kind kind, std::string_view text)
{
    std::string bytes(sizeof serial, '\0');
    std::memcpy(bytes.data(), &serial, sizeof serial);
    bytes += static_cast<char>(kind);
    return bytes.append(text);
}

void sendPacket(int socket, const std::string& packet)
{
    // Whoever does not listen any more is dead, which is noticed where we listen.
    while (::send(socket, packet.data(), packet.size(), MSG_NOSIGNAL) < 0 && errno == EINTR) {
    }
}

/// Nothing at the other side's end.
std::optional<HandMessage> receivePacket(int socket, int flags = 0)
{
    std::string bytes(longestMessage + 64, '\0');
    ssize_t got = 0;
    do
        got = ::recv(socket, bytes.data(), bytes.size(), flags);
    while (got < 0 && errno == EINTR);
    HandMessage message;
    if (got < static_cast<ssize_t>(sizeof message.serial) + 1)
        return std::nullopt;
    std::memcpy(&message.serial, bytes.data(), sizeof message.serial);
    message.kind = static_cast<CrewEvent::Kind>(bytes[sizeof message.serial]);
    message.text = bytes.substr(sizeof message.serial + 1, static_cast<std::size_t>(got) - sizeof message.serial - 1);
    return message;
}

/// A signal handler reaches nothing but globals.
Progress theProgress;

void onTerminate(int /*signal*/)
{
    theProgress.cancel = true;
}

/// The caller's death is this process's, too.
void dieWith(pid_t parent)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) // it died before
        ::_exit(1);
}

/// What it throws is a crash: it must not reach the code that the owner goes on with.
void workUntilTheEnd(int socket, const CrewWork& work, InHand& inHand) noexcept
{
    std::signal(SIGTERM, onTerminate);
    while (const auto next = receivePacket(socket, MSG_PEEK)) {
        inHand = next->serial;
        const auto job = receivePacket(socket);
        const std::string result = work(job->text, theProgress);
        CHECK_LE(result.size(), longestMessage);
        sendPacket(socket, packed(job->serial, CrewEvent::Kind::Finished, result));
        inHand = 0;
    }
}

std::string howItDied(int status)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return "its process was killed, perhaps because the memory was used up";
    const char* signal = WIFSIGNALED(status) ? ::sigdescr_np(WTERMSIG(status)) : nullptr;
    if (signal)
        return std::string("its process crashed: ") + signal;
    return "its process ended with exit code " + std::to_string(WEXITSTATUS(status));
}

/// Starts workers, one after the death of the other, until one ends because there is no more work.
void keepWatch(int socket, const CrewWork& work) noexcept
{
    // Shared with the worker; zeros at first.
    void* page = ::mmap(nullptr, sizeof(InHand), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED)
        return;
    InHand& inHand = *new (page) InHand(0);
    for (;;) {
        const pid_t self = ::getpid();
        const pid_t worker = ::fork();
        if (worker < 0)
            return;
        if (worker == 0) {
            dieWith(self);
            workUntilTheEnd(socket, work, inHand);
            ::_exit(0);
        }
        int status = 0;
        while (::waitpid(worker, &status, 0) < 0 && errno == EINTR) {
        }
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            return;
        if (const std::uint64_t serial = inHand.exchange(0); serial != 0)
            sendPacket(socket, packed(serial, CrewEvent::Kind::Died, howItDied(status)));
    }
}

} // namespace

Result<HandProcess> HandProcess::start(const CrewWork& work)
{
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return Error{"no process can be started to compute in (" + std::string(std::strerror(errno)) + ")"};
    const pid_t self = ::getpid();
    const pid_t keeper = ::fork();
    if (keeper < 0) {
        const std::string why = std::strerror(errno);
        ::close(ends[0]);
        ::close(ends[1]);
        return Error{"no process can be started to compute in (" + why + ")"};
    }
    if (keeper == 0) {
        ::setpgid(0, 0); // out of reach of the terminal's Ctrl-C
        dieWith(self);
        std::signal(SIGTERM, SIG_IGN); // the worker's to hear
        // Nothing else of the owner's stays open here: locks on his files and the other hands' sockets would outlive him.
        ::dup2(ends[1], STDERR_FILENO + 1);
        ::close_range(STDERR_FILENO + 2, ~0U, 0);
        keepWatch(STDERR_FILENO + 1, work);
        ::_exit(0);
    }
    ::setpgid(keeper, keeper); // whoever of the two comes first
    ::close(ends[1]);
    return HandProcess(ends[0], keeper);
}

HandProcess::HandProcess(HandProcess&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), keeper_(std::exchange(other.keeper_, -1))
{
}

void HandProcess::dismiss()
{
    if (socket_ >= 0)
        ::close(std::exchange(socket_, -1));
    if (keeper_ > 0)
        ::kill(-keeper_, SIGTERM);
}

HandProcess::~HandProcess()
{
    dismiss();
    if (keeper_ <= 0)
        return;
    constexpr std::chrono::milliseconds pause{5};
    constexpr int patience = 600; // pauses: three seconds
    for (int i = 0; i < patience; ++i) {
        if (::waitpid(keeper_, nullptr, WNOHANG) != 0)
            return;
        std::this_thread::sleep_for(pause);
    }
    ::kill(-keeper_, SIGKILL);
    ::waitpid(keeper_, nullptr, 0);
}

void HandProcess::give(std::uint64_t serial, std::string_view job) const
{
    CHECK_LE(job.size(), longestMessage);
    sendPacket(socket_, packed(serial, CrewEvent::Kind::Ready, job));
}

HandMessage HandProcess::hear() const
{
    return receivePacket(socket_).value_or(HandMessage{CrewEvent::Kind::Gone});
}

} // namespace reflectance
