// Ranks without MPI: a link whose other ends the test plays, so that they can be slow, silent and dead as it pleases.
#include "core/study/crew/rank_crew.h"

#include <deque>
#include <functional>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace reflectance {
namespace {

using Kind = CrewEvent::Kind;
using Say = RankMessage::Kind;

/// What was sent and what is to be received, seen from outside.
struct Post {
    std::deque<RankLink::Message> coming;
    std::vector<std::pair<int, RankMessage>> sent;
    bool isFinished = false;
    std::function<void(const RankMessage&)> onSend;

    void say(int from, const RankMessage& message) { coming.push_back({from, written(message)}); }
    [[nodiscard]] std::vector<RankMessage> sentTo(int rank, Say kind) const
    {
        std::vector<RankMessage> found;
        for (const auto& [to, message] : sent)
            if (to == rank && message.kind == kind)
                found.push_back(message);
        return found;
    }
};

class PlayedLink : public RankLink {
public:
    PlayedLink(Post& post, int size) : post_(post), size_(size) {}
    [[nodiscard]] int size() const override { return size_; }
    void send(int to, std::string text) override
    {
        const auto message = readRankMessage(text);
        ASSERT_TRUE(message) << text;
        post_.sent.emplace_back(to, *message);
        if (post_.onSend)
            post_.onSend(*message);
    }
    std::optional<Message> receive() override
    {
        if (post_.coming.empty())
            return std::nullopt;
        Message message = post_.coming.front();
        post_.coming.pop_front();
        return message;
    }
    bool flush() override { return true; }
    void finish() override { post_.isFinished = true; }

private:
    Post& post_;
    int size_;
};

constexpr std::chrono::milliseconds aWhile{50};
const RankPatience forever{std::chrono::hours(1), std::chrono::hours(1)};
const RankPatience none{std::chrono::milliseconds(0), std::chrono::milliseconds(0)};

std::unique_ptr<RankCrew> firstOf(Post& post, int size, const RankPatience& patience = forever)
{
    return std::make_unique<RankCrew>(std::make_unique<PlayedLink>(post, size), nullptr, patience);
}

pid_t somebodyDead()
{
    const pid_t dead = ::fork();
    if (dead == 0)
        ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    return dead;
}

TEST(Ranks, MessagesAreReadAsTheyWereWritten)
{
    for (const std::string& text : {std::string(), std::string("a\nb c"), std::string("\0x", 2)}) {
        const auto read = readRankMessage(written({Say::Died, 7, 1234567890123U, text}));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->kind, Say::Died);
        EXPECT_EQ(read->hand, 7U);
        EXPECT_EQ(read->serial, 1234567890123U);
        EXPECT_EQ(read->text, text);
    }
    for (const char* bad : {"", "J", "J 1 2", "J x 2\n", "J 1 -2\n", "JJ 1 2\n", "J 1 2 3\n"})
        EXPECT_FALSE(readRankMessage(bad)) << bad;
}

TEST(Ranks, GreetAreGivenWorkAndAnswer)
{
    Post post;
    const auto crew = firstOf(post, 3);
    EXPECT_TRUE(crew->wait(aWhile).empty()) << "nobody has greeted";
    post.say(2, {Say::Hello, 2, 0, "far away"});
    post.say(1, {Say::Hello, 1, 0, "far away"});
    const auto ready = crew->wait(aWhile);
    ASSERT_EQ(ready.size(), 3U);
    crew->give(1, "the job"); // the second hand of rank 2, who came first
    const auto jobs = post.sentTo(2, Say::Job);
    ASSERT_EQ(jobs.size(), 1U);
    EXPECT_EQ(jobs[0].hand, 1U);
    EXPECT_EQ(jobs[0].text, "the job");
    post.say(2, {Say::Finished, 1, jobs[0].serial + 1, "of another job"}); // the planted fault: it must not count
    post.say(2, {Say::Finished, 1, jobs[0].serial, "the result"});
    const auto events = crew->wait(aWhile);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, Kind::Finished);
    EXPECT_EQ(events[0].hand, 1U);
    EXPECT_EQ(events[0].text, "the result");
}

TEST(Ranks, ASilentOneIsGivenUpAndWelcomeWhenItComesBack)
{
    Post post;
    auto crew = firstOf(post, 2, none);
    post.say(1, {Say::Hello, 1, 0, "far away"});
    const auto first = crew->wait(aWhile); // greets, and has no time to say more
    ASSERT_EQ(first.size(), 2U);
    EXPECT_EQ(first[0].kind, Kind::Ready);
    EXPECT_EQ(first[1].kind, Kind::Gone);
    post.say(1, {Say::Finished, 0, 1, "too late"});
    const auto back = crew->wait(aWhile);
    ASSERT_FALSE(back.empty());
    EXPECT_EQ(back[0].kind, Kind::Ready) << "its result is another's by now";
    crew.reset();
    EXPECT_FALSE(post.isFinished) << "who waits for all waits for the dead";
    EXPECT_EQ(post.sentTo(1, Say::End).size(), 1U) << "it may live";
}

TEST(Ranks, ADeathOnThisHostIsSeenAtOnce)
{
    const pid_t dead = somebodyDead();
    Post post;
    const auto crew = firstOf(post, 3);
    post.say(1, {Say::Hello, 2, static_cast<std::uint64_t>(dead), hostHere()});
    post.say(2, {Say::Hello, 1, static_cast<std::uint64_t>(dead), "another host"});
    const auto events = crew->wait(aWhile);
    ASSERT_EQ(events.size(), 5U);
    EXPECT_EQ(events[3].kind, Kind::Gone);
    EXPECT_EQ(events[4].kind, Kind::Gone);
    EXPECT_EQ(events[4].hand, 1U) << "both of rank 1, and none of another host's";
}

TEST(Ranks, PartInOrderWhenAllLive)
{
    Post post;
    auto crew = firstOf(post, 2);
    post.say(1, {Say::Hello, 1, static_cast<std::uint64_t>(::getpid()), hostHere()});
    EXPECT_EQ(crew->wait(aWhile).size(), 1U);
    crew.reset();
    EXPECT_TRUE(post.isFinished);
    EXPECT_EQ(post.sentTo(1, Say::End).at(0).hand, 1U);
}

std::unique_ptr<LocalCrew> oneHand()
{
    return *LocalCrew::create(1, [](std::string_view job, Progress&) -> std::string {
        if (job == "die")
            ::_exit(9);
        return "did " + std::string(job);
    });
}

TEST(Ranks, WorkForTheFirstUntilTheEnd)
{
    Post post;
    PlayedLink link(post, 2);
    std::vector<RankMessage> heard;
    post.onSend = [&](const RankMessage& message) { // this is the first rank
        if (message.kind == Say::Hello)
            post.say(0, {Say::Job, 0, 5, "a"});
        else if (message.kind != Say::Alive)
            heard.push_back(message);
        if (message.kind == Say::Finished)
            post.say(0, {Say::Job, 0, 6, "die"});
        if (message.kind == Say::Died)
            post.say(0, {Say::End, 1});
    };
    const auto worked = workForFirstRank(link, oneHand(), forever);
    ASSERT_TRUE(worked) << worked.error().sentence();
    ASSERT_EQ(heard.size(), 2U);
    EXPECT_EQ(heard[0].serial, 5U);
    EXPECT_EQ(heard[0].text, "did a");
    EXPECT_EQ(heard[1].serial, 6U);
    EXPECT_NE(heard[1].text.find("exit code 9"), std::string::npos);
    EXPECT_TRUE(post.isFinished);
}

TEST(Ranks, DoOneJobAfterTheOther)
{
    Post post;
    PlayedLink link(post, 2);
    std::vector<std::string> results;
    post.onSend = [&](const RankMessage& message) {
        if (message.kind == Say::Hello) { // given up and back again: it gets work beside what it has
            post.say(0, {Say::Job, 0, 5, "a"});
            post.say(0, {Say::Job, 0, 6, "b"});
        }
        if (message.kind == Say::Finished)
            results.push_back(std::to_string(message.serial) + " " + message.text);
        if (results.size() == 2)
            post.say(0, {Say::End, 0});
    };
    ASSERT_TRUE(workForFirstRank(link, oneHand(), forever));
    EXPECT_EQ(results, (std::vector<std::string>{"5 did a", "6 did b"}));
    EXPECT_FALSE(post.isFinished) << "somebody is dead";
}

TEST(Ranks, EndAtOnceWhenTheFirstDiesOnThisHost)
{
    Post post;
    PlayedLink link(post, 2);
    post.say(0, {Say::Hello, 1, static_cast<std::uint64_t>(somebodyDead()), hostHere()});
    EXPECT_FALSE(workForFirstRank(link, oneHand(), forever));
}

TEST(Ranks, EndWhenTheFirstIsSilent)
{
    Post post;
    PlayedLink link(post, 2);
    const auto worked = workForFirstRank(link, oneHand(), none);
    ASSERT_FALSE(worked);
    EXPECT_NE(worked.error().message.find("does not hear of the first"), std::string::npos);
}

} // namespace
} // namespace reflectance
