// Users' spectra: every form that is read, and one sentence for every way to be wrong.
#include "core/spectra/builtin.h"

#include <gtest/gtest.h>

namespace reflectance {
namespace {

Result<SpectraFile> parse(std::string_view csv, SpectrumRole role = SpectrumRole::Reflectance)
{
    return parseSpectra(csv, role, "a.csv");
}

void expectSame(std::string_view csv, const Spectrum& expected)
{
    const auto file = parse(csv);
    ASSERT_TRUE(file) << csv << ": " << file.error().sentence();
    ASSERT_EQ(file->spectra.size(), 1U) << csv;
    EXPECT_EQ(file->spectra[0].name, expected.name) << csv;
    ASSERT_EQ(file->spectra[0].nm.size(), expected.nm.size()) << csv;
    for (std::size_t i = 0; i < expected.nm.size(); ++i) {
        // One product with 1000 or 0.01 rounds once.
        EXPECT_DOUBLE_EQ(file->spectra[0].nm[i], expected.nm[i]) << csv;
        EXPECT_DOUBLE_EQ(file->spectra[0].values[i], expected.values[i]) << csv;
    }
}

TEST(SpectraFile, OneSpectrumInManyForms)
{
    Spectrum s;
    s.name = "red";
    s.nm = {400, 550, 700};
    s.values = {0.1, 0.25, 0.5};
    expectSame("wavelength (nm),red\n400,0.1\n550,0.25\n700,0.5\n", s);
    expectSame("\xEF\xBB\xBFnm;red\r\n400;0.1\r\n550;0.25\r\n700;0.5", s);
    expectSame("# a note\n\nnm red\n400 0.1\n  550   0.25\n700 0.5\n", s);
    expectSame("wavelength_um,red\n0.4,0.1\n0.55,0.25\n0.7,0.5\n", s);
    expectSame("lambda (\xC2\xB5m)\tred\n0.4\t0.1\n0.55\t0.25\n0.7\t0.5\n", s);
    expectSame("wavelength,red\n0.4,0.1\n0.55,0.25\n0.7,0.5\n", s);
    expectSame("nm (values in %),red\n400,10\n550,25\n700,50\n", s);
    s.name = "red [percent]";
    expectSame("nm,red [percent]\n400,10\n550,25\n700,50\n", s);
    s.name = "column 2";
    expectSame("400,0.1\n550,0.25\n700,0.5\n", s);
}

TEST(SpectraFile, ManySpectraKeepTheirNames)
{
    const auto file = parse("nm,a,b,c\n400,1,2,3\n410,4,5,6\n", SpectrumRole::Sensor);
    ASSERT_TRUE(file);
    ASSERT_EQ(file->spectra.size(), 3U);
    EXPECT_EQ(file->spectra[2].name, "c");
    EXPECT_EQ(file->spectra[1].values[1], 5.0);
    EXPECT_EQ(file->spectra[1].outside, Outside::Zero);
}

TEST(SpectraFile, PercentReadAsFractionIsSaid)
{
    const auto file = parse("nm,red\n400,10\n500,87\n");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_NE(file->warnings[0].find("percent"), std::string::npos) << file->warnings[0];
    EXPECT_EQ(parse("nm,red\n400,0.1\n500,1.9\n")->warnings.size(), 0U);
    EXPECT_EQ(parse("nm,red\n400,0.1\n500,-0.01\n")->warnings.size(), 1U);
}

struct Bad {
    const char* csv;
    SpectrumRole role;
    const char* says;
    long line;
};

TEST(SpectraFile, EveryFaultHasItsSentence)
{
    using enum SpectrumRole;
    const Bad rows[] = {{"", Reflectance, "0 samples", 0},
                        {"nm,red\n", Reflectance, "0 samples", 0},
                        {"nm,red\n400,0.1\n", Reflectance, "1 samples", 0},
                        {"400\n500\n", Reflectance, "only one column", 1},
                        {"nm,red\n500,1\n400,1\n", Reflectance, "400 follows 500", 3},
                        {"nm,red\n500,1\n500,1\n", Reflectance, "500 follows 500", 3},
                        {"nm,red\n400,1\n500,x\n", Reflectance, "'x' is not a finite number", 3},
                        {"nm,red\n400,1\n500,\n", Reflectance, "'' is not a finite number", 3},
                        {"nm,red\n400,1\n500,nan\n", Reflectance, "not a finite number", 3},
                        {"nm,red\n400,1\n500,inf\n", Reflectance, "not a finite number", 3},
                        {"nm,red,green\n400,1,1\n\n500,1\n", Reflectance, "2 columns where 3", 4},
                        {"nm,red\n-5,1\n500,1\n", Reflectance, "not above 0", 2},
                        {"nm,red\n400,1\n500,-0.1\n", Sensor, "a sensitivity cannot be negative", 0},
                        {"nm,red\n400,1\n500,-0.1\n", Light, "power cannot be negative", 0},
                        {"nm,red\n400,0\n500,0\n", Sensor, "0 everywhere", 0}};
    for (const Bad& bad : rows) {
        const auto file = parse(bad.csv, bad.role);
        ASSERT_FALSE(file) << bad.csv;
        EXPECT_NE(file.error().message.find(bad.says), std::string::npos) << bad.csv << ": " << file.error().sentence();
        EXPECT_EQ(file.error().line, bad.line) << bad.csv;
        EXPECT_EQ(file.error().file, "a.csv");
    }
}

TEST(SpectraFile, AnUnknownNameTellsWhatThereIs)
{
    const auto sensor = sensorNamed("nikkon");
    ASSERT_FALSE(sensor);
    EXPECT_NE(sensor.error().message.find("nikon_d5100"), std::string::npos);
    EXPECT_FALSE(sensorNamed("gaussian:1.5"));
    EXPECT_FALSE(sensorNamed("gaussian:x"));
    EXPECT_FALSE(reflectancesNamed("grey:-1"));
    EXPECT_FALSE(primariesNamed("colorchecker"));
    EXPECT_FALSE(lightNamed("display"));
}

} // namespace
} // namespace reflectance
