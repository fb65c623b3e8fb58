// Exported headers compile alone as C++17 (the build has done it) and check themselves; what was changed is caught.
#include "list.gen.h"

#include <gtest/gtest.h>
#include <string>

#define DECLARE(id) int failures_##id(bool single);
FOR_EACH_EXPORTED(DECLARE)

namespace reflectance::test {
namespace {

struct Unit {
    std::string id;
    int (*failures)(bool single);
};

#define ENTRY(id) {#id, failures_##id},
const Unit units[] = {FOR_EACH_EXPORTED(ENTRY)};

TEST(ExportedCpp, HoldsInDoubleAndFloat)
{
    EXPECT_GT(std::size(units), 18U);
    for (const Unit& unit : units)
        if (!unit.id.starts_with("planted")) {
            EXPECT_EQ(unit.failures(false), 0) << unit.id << " in double";
            EXPECT_EQ(unit.failures(true), 0) << unit.id << " in float";
        }
}

/// A ten-thousandth of a constant of the formula, a thousandth of a parameter.
TEST(ExportedCpp, CatchesPlantedFaults)
{
    EXPECT_GT(failures_planted_constant(false), 0);
    EXPECT_GT(failures_planted_parameter(false), 0);
    EXPECT_GT(failures_planted_parameter(true), 0);
}

} // namespace
} // namespace reflectance::test
