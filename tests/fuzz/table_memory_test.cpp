// Reading a measured surface takes memory in proportion to the file, whatever it announces.
#include "core/measured/load.h"
#include "tests/fuzz/counted_memory.h"
#include "tests/fuzz/table_readers.h"
#include "tests/measured/made_files.h"

#include <gtest/gtest.h>
#include <iostream>

namespace reflectance::fuzz {
namespace {

constexpr std::size_t size = 1'000'000;

std::string repeated(std::string_view text)
{
    std::string result;
    while (result.size() < size)
        result += text;
    return result;
}

/// A column of angles that climbs.
std::string climbingRows(const std::string& before, const std::string& after)
{
    std::string rows;
    for (int i = 10000; i < 80000; ++i)
        rows += before + std::to_string(i) + "e-3" + after;
    return rows;
}

struct Greedy {
    const char* what;
    std::string bytes;
};

std::vector<Greedy> greedyFiles()
{
    const std::string head = "theta_i_deg,theta_r_deg,f\n";
    return {
        {"csv rows", head + climbingRows("0,", ",1\n")},
        {"csv columns", repeated("f,")},
        {"csv fields", head + repeated("0,")},
        {"csv that makes no grid", head + climbingRows("", ",0,1\n") + "89,1,1\n"},
        {"csv scattered",
         "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,f\n" + repeated("1,0,1,0,1\n").substr(0, 300000)},
        {"json rows", R"({"brdf": {"lookupTable": [)" + climbingRows("[5e-7,0,0.0", ",0,1],\n") + "[5e-7,1,1,0,1]]}}"},
        {"json brackets", repeated("[")},
        {"json empty lists", R"({"brdf": {"lookupTable": [)" + repeated("[],") + "[]]}}"},
        {"json empty objects", R"({"brdf": {"lookupTable": [)" + repeated("{},") + "[]]}}"},
        {"merl cells of one row", testing::merlFile(1, 1, 40000, {1, 1, 1})},
        {"merl that asks for 1e12 cells", testing::merlFile(10000, 10000, 10000, {}) + repeated("x")},
        {"zemax angles", "Source Measured\nScatterRadial 500000\n" + repeated("0 ")},
        {"zemax numbers", testing::zemaxFile() + repeated("0 ")},
        {"cornell wavelengths", "900000\n" + repeated("5 ")},
        {"cornell values", "1\n500\n" + repeated("0 0 0 0 1\n").substr(0, 400000)},
    };
}

TEST(TableMemory, IsBoundedByTheSizeOfTheFile)
{
    for (const Greedy& file : greedyFiles()) {
        const std::size_t before = restartPeak();
        (void)readMeasurement(file.bytes, "a.table");
        const double greed = static_cast<double>(peakMemory() - before) / static_cast<double>(file.bytes.size());
        std::cout << file.what << ": " << greed << '\n';
        EXPECT_LT(greed, static_cast<double>(mostOfTable)) << file.what;
    }
}

} // namespace
} // namespace reflectance::fuzz
