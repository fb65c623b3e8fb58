// Files in, answers out: which model serves which surface.
#include "core/base/file.h"
#include "core/measured/write.h"
#include "core/study/fit/survey_page.h"
#include "tests/study/fit/synthetic.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reflectance;
using testing::HasSubstr;

namespace {

namespace fs = std::filesystem;

/// A folder with a matte, a shiny and a rough surface, and a note that is no measurement; it goes away with the test.
class SurveyFolder {
public:
    SurveyFolder()
    {
        std::string name = (fs::temp_directory_path() / "reflectance-survey-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
        write("matte", {"lambert", {{"kd", {0.5}}}, 0.005, 1, 1, {}});
        write("shiny",
              {"hybrid", {{"K", {0.2, 0, 0, 0, 0.2, 0, 0, 0, 0.2}}, {"ks", {0.8}}, {"n", {12.0}}}, 0.005, 2, 1, {}});
        write("rough", {"oren_nayar", {{"rho", {0.8, 0.8, 0.8}}, {"sigma", {1.0}}}, 0.005, 3, 1, {}});
        EXPECT_TRUE(writeAtomically((path_ / "note.txt").string(), "not a table\n"));
    }
    ~SurveyFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    SurveyFolder(const SurveyFolder&) = delete;
    SurveyFolder& operator=(const SurveyFolder&) = delete;

    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    void write(const std::string& name, const SyntheticTable& wanted) const
    {
        EXPECT_TRUE(writeAtomically((path_ / (name + ".csv")).string(), csvText(synthetic(wanted))));
    }
    fs::path path_;
};

FitOptions fewStarts()
{
    FitOptions options;
    options.starts = 2;
    return options;
}

/// In the order of their names: matte, rough, shiny.
const Survey& theSurvey()
{
    static const SurveyFolder folder;
    static const Survey result = *survey({folder.path()}, fewStarts());
    return result;
}

} // namespace

TEST(Survey, FindsTheSurfacesAndSaysWhatItLeftOut)
{
    ASSERT_EQ(theSurvey().surfaces.size(), 3U);
    EXPECT_EQ(theSurvey().surfaces[0].name, "matte");
    EXPECT_EQ(theSurvey().surfaces[2].name, "shiny");
    ASSERT_EQ(theSurvey().skipped.size(), 1U);
    EXPECT_THAT(theSurvey().skipped[0], HasSubstr("note.txt"));
}

TEST(Survey, AnswersTheQuestionAsTheSurfacesWereMade)
{
    const auto& surfaces = theSurvey().surfaces;
    EXPECT_EQ(servedBy(theSurvey(), surfaces[0], 0.05), ServedBy::Lambert);
    EXPECT_EQ(servedBy(theSurvey(), surfaces[1], 0.05), ServedBy::Neither);
    EXPECT_EQ(servedBy(theSurvey(), surfaces[2], 0.05), ServedBy::Hybrid);
    // Planted: were every surface within 100 %, Lambert would serve all of them.
    for (const SurveyedSurface& surface : surfaces)
        EXPECT_EQ(servedBy(theSurvey(), surface, 1.0), ServedBy::Lambert);
}

TEST(Survey, TheModelThatMadeASurfaceIsBestByBicOrAsGood)
{
    const char* const makers[] = {"lambert", "oren_nayar", "hybrid"};
    for (std::size_t i = 0; i < 3; ++i) {
        const SurveyedSurface& surface = theSurvey().surfaces[i];
        double own = 0.0;
        for (std::size_t c = 0; c < theSurvey().candidates.size(); ++c)
            if (theSurvey().candidates[c].label == makers[i])
                own = surface.fits[c]->bic;
        // Two models that differ by less than 10 are told apart by the noise alone (Kass and Raftery 1995).
        EXPECT_LT(own, surface.fits[*bestByBic(surface)]->bic + 10.0) << surface.name;
    }
}

TEST(Survey, TheCheapestIsWithinTheToleranceAndNoneIsCheaper)
{
    for (const SurveyedSurface& surface : theSurvey().surfaces) {
        const auto cheapest = cheapestWithin(theSurvey(), surface, 0.05);
        ASSERT_TRUE(cheapest);
        EXPECT_LE(surface.fits[*cheapest]->relativeRms, 0.05);
        for (std::size_t c = 0; c < surface.fits.size(); ++c)
            if (surface.fits[c] && surface.fits[c]->relativeRms <= 0.05) {
                EXPECT_GE(theSurvey().candidates[c].nsSimd, theSurvey().candidates[*cheapest].nsSimd);
            }
        EXPECT_FALSE(cheapestWithin(theSurvey(), surface, 1e-9));
    }
}

TEST(Survey, CostsAreMeasured)
{
    for (const FittedModel& candidate : theSurvey().candidates) {
        EXPECT_GT(candidate.nsDouble, 0.0) << candidate.label;
        EXPECT_GT(candidate.nsSimd, 0.0) << candidate.label;
    }
}

TEST(Survey, ThePageGivesTheAnswerAndLinksItsDrawings)
{
    const std::string page = pageOf(theSurvey(), 0.05, "images/real-surfaces-");
    EXPECT_THAT(
        page,
        HasSubstr("Of 3 surfaces, within 5 %, Lambert serves 1, the hybrid serves 1 more, and 1 are in the middle"));
    for (const Drawing& drawing : drawingsOf(theSurvey(), 0.05)) {
        EXPECT_THAT(page, HasSubstr("](images/real-surfaces-" + drawing.name + ".svg)"));
        EXPECT_FALSE(drawing.chart.series.empty()) << drawing.name;
    }
    EXPECT_THAT(page, HasSubstr("| matte | 392 |"));
    Survey weighted = theSurvey(); // the command that is printed must give the same figures
    weighted.options.cosine = true;
    weighted.options.weighting = Weighting::Logarithmic;
    EXPECT_THAT(pageOf(weighted, 0.05, ""), HasSubstr("FOLDER... --all --cosine --weights log --markdown"));
}

TEST(Survey, RefusesWhatIsNoMeasurement)
{
    const SurveyFolder folder;
    EXPECT_THAT(survey({folder.path() + "/note.txt"}, {}).error().sentence(), HasSubstr("note.txt"));
    EXPECT_FALSE(survey({folder.path() + "/missing"}, {}));
    fs::create_directory(folder.path() + "/empty");
    EXPECT_THAT(survey({folder.path() + "/empty"}, {}).error().sentence(), HasSubstr("holds no measured surface"));
    Progress progress;
    progress.cancel = true;
    EXPECT_FALSE(survey({folder.path()}, {}, &progress));
}

/// One surface and few starts: what counts is the file.
TEST(Survey, GoesOnBehindWhatAnEarlierRunKept)
{
    const SurveyFolder folder;
    const std::string surface = folder.path() + "/matte.csv";
    SurveyRun run;
    run.journal = folder.path() + "/fits";
    run.workers = 2;
    FitOptions options;
    options.starts = 1;
    const auto first = survey({surface}, options, nullptr, run);
    ASSERT_TRUE(first) << first.error().sentence();
    const std::string whole = *readWholeFile(run.journal);

    // Torn in the middle of a fit: the fit and all behind it are made again, and equal.
    EXPECT_TRUE(writeAtomically(run.journal, whole.substr(0, whole.size() / 2)));
    const auto second = survey({surface}, options, nullptr, run);
    ASSERT_TRUE(second) << second.error().sentence();
    EXPECT_EQ(*readWholeFile(run.journal), whole);
    ASSERT_EQ(second->surfaces.size(), 1U);
    ASSERT_EQ(second->surfaces[0].fits.size(), first->candidates.size());
    for (std::size_t i = 0; i < first->candidates.size(); ++i) {
        ASSERT_EQ(first->surfaces[0].fits[i].has_value(), second->surfaces[0].fits[i].has_value());
        if (const auto& fit = first->surfaces[0].fits[i]) {
            EXPECT_EQ(fit->rms, second->surfaces[0].fits[i]->rms) << first->candidates[i].label;
        }
    }

    // The planted fault: fits of other options must not be taken for these.
    options.cosine = true;
    EXPECT_THAT(survey({surface}, options, nullptr, run).error().sentence(), HasSubstr("other surfaces or options"));
    EXPECT_EQ(*readWholeFile(run.journal), whole);
}
