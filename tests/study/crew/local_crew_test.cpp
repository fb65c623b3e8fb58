// Hands in processes of their own: what they compute, how they die, what they leave behind.
#include "core/study/crew/foreman.h"
#include "core/study/crew/local_crew.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace reflectance {
namespace {

using Kind = CrewEvent::Kind;

/// Squares, unless told to die.
std::string work(std::string_view job, Progress& progress)
{
    const std::string text(job);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none); // these deaths are meant
    if (text == "segmentation")
        std::signal(SIGSEGV, SIG_DFL), std::raise(SIGSEGV);
    if (text == "kill")
        std::raise(SIGKILL);
    if (text == "exit")
        ::_exit(3);
    while (text == "wait" && !progress.cancel)
        std::this_thread::yield();
    if (text == "wait")
        return "";
    if (text == "process")
        return std::to_string(::getpid());
    if (text == "long")
        return std::string(longestMessage, 'x');
    return std::to_string(std::stol(text) * std::stol(text));
}

std::vector<CrewEvent> waitFor(Crew& crew)
{
    for (;;)
        if (auto events = crew.wait(std::chrono::milliseconds(100)); !events.empty())
            return events;
}

CrewEvent answerTo(Crew& crew, std::string_view job)
{
    crew.give(0, job);
    return waitFor(crew).front();
}

std::unique_ptr<LocalCrew> crewOf(unsigned hands)
{
    auto crew = LocalCrew::create(hands, work);
    EXPECT_TRUE(crew);
    return *std::move(crew);
}

TEST(LocalCrews, ComputeTheSameForAnyNumberOfHands)
{
    for (const unsigned hands : {1U, 2U, 5U}) {
        const auto crew = crewOf(hands);
        JobList jobs;
        jobs.end = 40;
        jobs.text = [](std::uint64_t job) { return std::to_string(job); };
        std::string all;
        jobs.take = [&](std::uint64_t job, const JobOutcome& outcome) {
            EXPECT_EQ(outcome.result, std::to_string(job * job));
            return Result<void>();
        };
        const auto done = Foreman(*crew).run(jobs);
        EXPECT_TRUE(done && *done);
    }
}

TEST(LocalCrews, ADeathIsToldWithItsReasonAndAnotherTakesThePlace)
{
    const auto crew = crewOf(1);
    EXPECT_EQ(waitFor(*crew).front().kind, Kind::Ready);
    for (const auto& [job, reason] :
         {std::pair("segmentation", "crashed: Segmentation fault"),
          std::pair("kill", "killed, perhaps because the memory was used up"), std::pair("exit", "exit code 3")}) {
        const CrewEvent died = answerTo(*crew, job);
        EXPECT_EQ(died.kind, Kind::Died);
        EXPECT_NE(died.text.find(reason), std::string::npos) << died.text;
        const CrewEvent next = answerTo(*crew, "12");
        EXPECT_EQ(next.kind, Kind::Finished);
        EXPECT_EQ(next.text, "144");
    }
}

TEST(LocalCrews, AHandThatDiesIdleIsReplacedUnheard)
{
    const auto crew = crewOf(1);
    waitFor(*crew);
    const pid_t first = std::stoi(answerTo(*crew, "process").text);
    ::kill(first, SIGKILL);
    const CrewEvent next = answerTo(*crew, "process");
    // Given before or after the death, the job is done by the next one, or was in the hand that was killed.
    if (next.kind == Kind::Finished) {
        EXPECT_NE(std::stoi(next.text), first);
    }
    EXPECT_EQ(answerTo(*crew, "3").text, "9");
}

TEST(LocalCrews, StayInTheirProcessAndCarryLongMessages)
{
    const auto crew = crewOf(1);
    waitFor(*crew);
    const std::string process = answerTo(*crew, "process").text;
    EXPECT_EQ(answerTo(*crew, "process").text, process);
    EXPECT_NE(std::stoi(process), ::getpid());
    EXPECT_EQ(answerTo(*crew, "long").text, std::string(longestMessage, 'x'));
}

bool isAlive(pid_t process)
{
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t name = text.rfind(") ");
    return name != std::string::npos && text[name + 2] != 'Z'; // nobody may have asked for its end
}

void waitForTheEndOf(pid_t process)
{
    while (isAlive(process))
        std::this_thread::yield();
}

TEST(LocalCrews, EndWithTheCrew)
{
    auto crew = crewOf(1);
    waitFor(*crew);
    const pid_t process = std::stoi(answerTo(*crew, "process").text);
    crew->give(0, "wait");
    crew.reset();
    EXPECT_FALSE(isAlive(process));
}

TEST(LocalCrews, EndWithAnOwnerWhoWasKilled)
{
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const pid_t owner = ::fork();
    if (owner == 0) {
        const auto crew = crewOf(1);
        waitFor(*crew);
        const pid_t process = std::stoi(answerTo(*crew, "process").text);
        crew->give(0, "wait");
        const bool told = ::write(ends[1], &process, sizeof process) == sizeof process;
        std::raise(told ? SIGKILL : SIGTERM);
    }
    pid_t process = 0;
    ASSERT_EQ(::read(ends[0], &process, sizeof process), static_cast<ssize_t>(sizeof process));
    ::waitpid(owner, nullptr, 0);
    waitForTheEndOf(process); // or the test's time limit tells
    ::close(ends[0]);
    ::close(ends[1]);
}

/// Else a killed sweep's file would stay locked.
TEST(LocalCrews, HoldNothingOfTheirOwnersOpen)
{
    const std::string path =
        (std::filesystem::temp_directory_path() / ("crew_lock_" + std::to_string(::getpid()))).string();
    const int first = ::open(path.c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_EQ(::flock(first, LOCK_EX), 0);
    const auto crew = crewOf(2);
    waitFor(*crew);
    EXPECT_EQ(answerTo(*crew, "3").text, "9"); // so it runs, and has closed what it does not need
    crew->give(1, "3");
    waitFor(*crew);
    ::close(first);
    const int second = ::open(path.c_str(), O_RDWR);
    EXPECT_EQ(::flock(second, LOCK_EX | LOCK_NB), 0);
    ::close(second);
    std::filesystem::remove(path);
}

} // namespace
} // namespace reflectance
