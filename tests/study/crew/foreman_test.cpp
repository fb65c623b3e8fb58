// The foreman against a crew that does what the test says: late, dead, gone.
#include "core/study/crew/foreman.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace reflectance {
namespace {

using Kind = CrewEvent::Kind;

/// Hands that answer when the test's function says so.
class Puppets : public Crew {
public:
    using Plan = std::function<std::vector<CrewEvent>(Puppets&)>;
    Puppets(std::size_t hands, Plan plan) : plan_(std::move(plan))
    {
        for (std::size_t i = 0; i < hands; ++i)
            news_.push_back({Kind::Ready, i});
    }
    void give(std::size_t hand, std::string_view job) override
    {
        EXPECT_FALSE(busy.contains(hand)) << "a hand has one job at a time";
        busy[hand] = job;
        given.emplace_back(job);
    }
    std::vector<CrewEvent> wait(std::chrono::milliseconds /*longest*/) override
    {
        std::vector<CrewEvent> events = news_.empty() ? plan_(*this) : std::exchange(news_, {});
        for (const CrewEvent& event : events)
            busy.erase(event.hand);
        return events;
    }

    std::map<std::size_t, std::string> busy;
    std::vector<std::string> given;

private:
    Plan plan_;
    std::vector<CrewEvent> news_;
};

/// The hand with the latest job is done first.
std::vector<CrewEvent> lastFirst(Puppets& crew)
{
    if (crew.busy.empty())
        return {};
    const auto last = std::prev(crew.busy.end());
    return {{Kind::Finished, last->first, "did " + last->second}};
}

struct Taken {
    std::vector<std::uint64_t> jobs;
    std::vector<JobOutcome> outcomes;
};

JobList jobsInto(Taken& taken, std::uint64_t first, std::uint64_t end)
{
    JobList jobs;
    jobs.first = first;
    jobs.end = end;
    jobs.text = [](std::uint64_t job) { return std::to_string(job); };
    jobs.take = [&taken](std::uint64_t job, const JobOutcome& outcome) {
        taken.jobs.push_back(job);
        taken.outcomes.push_back(outcome);
        return Result<void>();
    };
    return jobs;
}

TEST(Foreman, TakesResultsInTheOrderOfTheJobs)
{
    Puppets crew(3, lastFirst);
    Taken taken;
    const auto done = Foreman(crew).run(jobsInto(taken, 5, 25));
    ASSERT_TRUE(done && *done);
    ASSERT_EQ(taken.jobs.size(), 20U);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(taken.jobs[i], i + 5);
        EXPECT_EQ(taken.outcomes[i].result, "did " + std::to_string(i + 5));
    }
    // The planted fault: had they been taken as they came, they would be out of order.
    EXPECT_NE(crew.given.size(), 0U);
    EXPECT_EQ(crew.given.front(), "5");
}

TEST(Foreman, GoesThroughSeveralListsWithTheSameHands)
{
    Puppets crew(2, lastFirst);
    Foreman foreman(crew);
    Taken taken;
    ASSERT_TRUE(foreman.run(jobsInto(taken, 0, 4)));
    ASSERT_TRUE(foreman.run(jobsInto(taken, 0, 3)));
    EXPECT_EQ(taken.jobs, (std::vector<std::uint64_t>{0, 1, 2, 3, 0, 1, 2}));
}

TEST(Foreman, ADeathFailsItsJobAlone)
{
    Puppets crew(2, [](Puppets& hands) -> std::vector<CrewEvent> {
        const auto& [hand, job] = *hands.busy.begin();
        return {{job == "3" ? Kind::Died : Kind::Finished, hand, job == "3" ? "crashed" : "fine"}};
    });
    Taken taken;
    ASSERT_TRUE(Foreman(crew).run(jobsInto(taken, 0, 6)));
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(taken.outcomes[i].failure, i == 3 ? "crashed" : "") << i;
    EXPECT_EQ(std::count(crew.given.begin(), crew.given.end(), "3"), 1) << "it would kill the next one, too";
}

TEST(Foreman, WhatAMachineTookAwayIsDoneByAnother)
{
    Puppets crew(3, [first = true](Puppets& hands) mutable -> std::vector<CrewEvent> {
        if (std::exchange(first, false))
            return {{Kind::Gone, 1}};
        return lastFirst(hands);
    });
    Taken taken;
    ASSERT_TRUE(Foreman(crew).run(jobsInto(taken, 0, 9)));
    for (const JobOutcome& outcome : taken.outcomes)
        EXPECT_EQ(outcome.failure, "");
    EXPECT_EQ(taken.jobs.size(), 9U);
}

TEST(Foreman, AJobThatTakesTwoMachinesAwayFails)
{
    Puppets crew(3, [](Puppets& hands) -> std::vector<CrewEvent> {
        for (const auto& [hand, job] : hands.busy)
            if (job == "1")
                return {{Kind::Gone, hand}};
        return lastFirst(hands);
    });
    Taken taken;
    const auto done = Foreman(crew).run(jobsInto(taken, 0, 8));
    ASSERT_TRUE(done) << done.error().sentence();
    EXPECT_NE(taken.outcomes[1].failure.find("was lost"), std::string::npos);
    EXPECT_EQ(std::count_if(taken.outcomes.begin(), taken.outcomes.end(), [](auto& o) { return !o.failure.empty(); }),
              1);
}

TEST(Foreman, WithoutHandsItSaysSo)
{
    Puppets crew(1, [](Puppets&) { return std::vector<CrewEvent>{{Kind::Gone, 0}}; });
    Taken taken;
    const auto done = Foreman(crew).run(jobsInto(taken, 0, 8));
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().message.find("no process is left"), std::string::npos);
}

TEST(Foreman, IsNeverFartherAheadThanItsLead)
{
    // Hand 0 never finishes job 0 before all others stand still.
    Puppets crew(2, [](Puppets& hands) -> std::vector<CrewEvent> {
        for (const auto& [hand, job] : hands.busy)
            if (job != "0")
                return {{Kind::Finished, hand, ""}};
        EXPECT_EQ(hands.given.size(), 2 * Foreman::lead) << "what a kill can lose";
        return {{Kind::Finished, hands.busy.begin()->first, ""}};
    });
    Taken taken;
    ASSERT_TRUE(Foreman(crew).run(jobsInto(taken, 0, 2 * Foreman::lead + 3)));
}

TEST(Foreman, StopsWhereAResultCannotBeTaken)
{
    Puppets crew(2, lastFirst);
    Taken taken;
    JobList jobs = jobsInto(taken, 0, 9);
    jobs.take = [](std::uint64_t job, const JobOutcome&) {
        return job < 2 ? Result<void>() : Error{"the disk is full"};
    };
    const auto done = Foreman(crew).run(jobs);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().message, "the disk is full");
}

TEST(Foreman, StopsWhenAsked)
{
    Puppets crew(1, lastFirst);
    Taken taken;
    const auto done = Foreman(crew).run(jobsInto(taken, 0, 9), [&] { return taken.jobs.size() == 3; });
    ASSERT_TRUE(done);
    EXPECT_FALSE(*done);
    EXPECT_EQ(taken.jobs.size(), 3U);
}

} // namespace
} // namespace reflectance
