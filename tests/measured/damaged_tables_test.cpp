// Measured files that are damaged: each is refused with a sentence that says what and where.
#include "core/measured/bytes.h"
#include "tests/measured/made_files.h"

#include <gmock/gmock.h>

namespace reflectance::testing {
namespace {

using ::testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "the piece to be replaced is missing" : text.replace(at, from.size(), to);
}

struct Refused {
    const char* what;
    std::string bytes;
    const char* sentence;
};

std::vector<Refused> refusedFiles()
{
    const std::string head = "theta_i_deg,theta_r_deg,f\n";
    const std::string good = head + "0,0,1\n0,10,1\n10,0,1\n10,10,1\n";
    const std::string zemax = zemaxFile();
    const std::string json = openMaterialFile();
    const std::string rgl = tensorFile(rglFields({{0.0F, {1, 1, 1, 1}, std::vector<float>(12, 1.0F)}}));
    std::string hugeMerl = merlFile(10000, 10000, 10000, {});
    return {
        {"nothing", "", "a.table: is empty"},
        {"a picture", std::string("\x89PNG\r\n\x1A\n\0\0", 10), "no measured table of a known format"},
        {"csv: rows missing", head + "0,0,1\n0,10,1\n10,0,1\n",
         "has 3 rows, but its angles make a grid of 2 x 2; the first one missing is theta_i = 10, theta_r = 10"},
        {"csv: a row twice", good + "10,10,2\n", "a.table:6: these angles stand here for the second time"},
        {"csv: not sorted", head + "0,10,1\n0,0,1\n", "a.table:3: the rows are not sorted; sort them by theta_i"},
        {"csv: a field too few", head + "0,0\n", "a.table:2: the row has 2 fields, the header 3"},
        {"csv: a word", head + "0,0,one\n", "a.table:2: \"one\" is not a number"},
        {"csv: an infinite value", head + "0,0,inf\n", "a value is infinite"},
        {"csv: an angle that is none", head + "nan,0,1\n", "the angle theta_i is nan"},
        {"csv: beyond the horizon", head + "0,95,1\n", "a.table:2: the angle theta_r is 95 degrees; 0 .. 90"},
        {"csv: below zero", head + "-5,0,1\n", "the angle theta_i is -5 degrees"},
        {"csv: radians that are degrees", "theta_i_rad,theta_r_rad,f\n0,45,1\n", "the angle theta_r is 2578"},
        {"csv: mixed units", "theta_i_deg,theta_r_rad,f\n0,0,1\n", "a.table:1: some angles are in degrees and some"},
        {"csv: no unit", "theta_i,theta_r,f\n0,0,1\n", "names no unit; write theta_i_deg or theta_i_rad"},
        {"csv: an unknown column", "theta_i_deg,theta_o_deg,f\n0,0,1\n", "did you mean theta_"},
        {"csv: a column twice", "theta_i_deg,theta_i_deg,f\n0,0,1\n", "twice"},
        {"csv: two channels", "theta_i_deg,theta_r_deg,f_red,f_green\n0,0,1,1\n", "value columns make no table"},
        {"csv: no row", head, "has a header and no row"},
        {"csv: nothing but holes", head + "0,0,nan\n", "nothing but holes"},
        {"csv: a cosine of half angles", "theta_h_deg,theta_d_deg,phi_d_deg,factor\n0,0,0,1\n", "half and difference"},
        {"merl: a negative dimension", merlFile(-90, -90, 180, {}), "its dimension 1 is -90"},
        {"merl: swapped dimensions", merlFile(90, 180, 90, {}), "90 x 180 x 90 instead of 90 x 90 x 180"},
        {"merl: cut short", merlFile(90, 90, 180, {0.5}), "ask for 34992012 bytes, but it has 11664012; get the whole"},
        {"merl: 1e12 cells", hugeMerl, "its dimensions ask for 24000000000012 bytes, but it has 12"},
        {"rgl: cut short", rgl.substr(0, 60), "get the whole file"},
        {"rgl: cut within its numbers", rgl.substr(0, rgl.size() - 4), "get the whole file"},
        {"rgl: version 2", replaced(rgl, std::string("tensor_file\0\1", 13), std::string("tensor_file\0\2", 13)),
         "version 2"},
        {"zemax: a count too large", replaced(zemax, "ScatterRadial 4", "ScatterRadial 1000000000000"),
         "announces 1000000000000 angles, but its line holds 4"},
        {"zemax: angles not ascending", replaced(zemax, "0 10 30 60", "0 30 10 60"), "do not ascend at 10"},
        {"zemax: beyond the horizon", replaced(zemax, "10 40", "10 94"), "an angle of incidence is 94 degrees"},
        {"zemax: cut short", zemax.substr(0, zemax.size() - 30), "a.table:"},
        {"zemax: transmission", replaced(zemax, "ScatterType BRDF", "ScatterType BTDF"), "only reflection"},
        {"zemax: no list", replaced(zemax, "ScatterAzimuth 3\n0 90 180\n", ""), "no list of angles scatterazimuth"},
        {"cornell: cut short", replaced(cornellFile(), "0.25 0.25 0.25\n0.2 0 0.3 3", "0.2 0 0.3 3"), "a.table"},
        {"cornell: a false count", replaced(cornellFile(), "3\n450", "1000000000000\n450"), "do not ascend"},
        {"cornell: degrees", replaced(cornellFile(), "0.7 0 0.7", "40 0 40"), "is 40 radians"},
        {"json: no json", "{\"metadata\": \n", "a.table:"},
        {"json: brackets without end", std::string(1000, '['), "nest deeper than one does"},
        {"json: another json", "{\"mesh\": \"mug\"}", "it has no list brdf.lookupTable"},
        {"json: a word in a row", replaced(json, "[5.5e-7, 1, 0, 0, 0.3]", "[5.5e-7, 1, \"0\", 0, 0.3]"),
         "row 5 of its look-up table: its column 3 must be a number"},
        {"json: degrees", replaced(json, "[5.5e-7, 1, 0, 0, 0.3]", "[5.5e-7, 60, 0, 0, 0.3]"), "is 60 radians"},
        {"json: nanometres", replaced(json, "[5.5e-7, 0, 0, 0", "[550, 0, 0, 0"), "not sorted"},
        {"json: a row missing", replaced(json, "[5.5e-7, 1, 0, 0, 0.3],", ""), "the first one missing is"},
        {"json: too large a number", replaced(json, "0.5]]", "1e999]]"), "too large"},
    };
}

TEST(DamagedTables, ARefusalSaysWhatAndWhere)
{
    for (const Refused& file : refusedFiles())
        EXPECT_THAT(refusal(file.bytes), HasSubstr(file.sentence)) << file.what;
}

TEST(DamagedTables, PlantedGoodFilesAreNotRefused)
{
    for (const std::string& bytes : {zemaxFile(), cornellFile(), openMaterialFile(), merlFile(2, 2, 2, {1, 1, 1})})
        EXPECT_EQ(refusal(bytes), "");
}

} // namespace
} // namespace reflectance::testing
