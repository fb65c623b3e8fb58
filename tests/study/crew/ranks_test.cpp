// What launchers write into the environment.
#include "core/study/crew/ranks.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <initializer_list>

namespace reflectance {
namespace {

class Launchers : public testing::Test {
protected:
    void SetUp() override { clear(); }
    void TearDown() override { clear(); }

    static void clear()
    {
        for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_LOCAL_SIZE", "PMIX_RANK", "PMI_RANK",
                                 "PMI_SIZE", "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_NTASKS_PER_NODE"})
            ::unsetenv(name);
    }
    static void set(std::initializer_list<std::pair<const char*, const char*>> variables)
    {
        for (const auto& [name, value] : variables)
            ::setenv(name, value, 1);
    }
};

TEST_F(Launchers, NoneIsOneProcess)
{
    const auto ranks = ranksHere();
    ASSERT_TRUE(ranks);
    EXPECT_FALSE(ranks->areMany);
    EXPECT_FALSE(isHelper());
    EXPECT_EQ(handsFor(7), 7U);
    EXPECT_GE(handsFor(0), 1U);
    EXPECT_EQ(threadsPerHand(100000), 1U);
}

TEST_F(Launchers, OpenMpi)
{
    set({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_LOCAL_SIZE", "100000"}});
    const auto ranks = ranksHere();
    ASSERT_TRUE(ranks);
    EXPECT_TRUE(ranks->areMany);
    EXPECT_FALSE(ranks->isFirst);
    EXPECT_TRUE(isHelper());
    EXPECT_EQ(handsFor(0), 1U) << "its cores are shared";
}

TEST_F(Launchers, SlurmWithPmix)
{
    set({{"PMIX_RANK", "0"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "4"}});
    const auto ranks = ranksHere();
    ASSERT_TRUE(ranks);
    EXPECT_TRUE(ranks->areMany);
    EXPECT_TRUE(ranks->isFirst);
}

TEST_F(Launchers, ThatDoNotJoinTheirCopiesAreRefused)
{
    set({{"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "4"}});
    EXPECT_FALSE(ranksHere());
    EXPECT_TRUE(isHelper()) << "one of them speaks";
    clear();
    set({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}});
    EXPECT_FALSE(ranksHere());
    EXPECT_FALSE(isHelper());
    set({{"PMI_SIZE", "1"}});
    EXPECT_TRUE(ranksHere()) << "alone it has nobody to find";
    clear();
    set({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "1"}}); // a job script that calls the program itself
    EXPECT_TRUE(ranksHere());
}

} // namespace
} // namespace reflectance
