#include "core/study/fit/survey_run.h"

#include "core/base/digest.h"
#include "core/base/text.h"
#include "core/study/crew/foreman.h"
#include "core/study/crew/journal.h"
#include "core/study/crew/launch.h"
#include "core/study/crew/ranks.h"
#include "core/study/fit/fit_record.h"

#include <optional>
#include <utility>

namespace reflectance {
namespace {

// What a job's line says after its number: a record, or why there is none. A model that cannot be fitted to a surface is no
// failure.
constexpr std::string_view isFitted = "fit\t", isUnfit = "none", hasFailed = "failed\t";

/// Everything that the fits depend on.
std::string digestOfInputs(const Survey& survey, const std::vector<SurveySubject>& subjects)
{
    const FitOptions& o = survey.options;
    std::string all = std::to_string(static_cast<int>(o.weighting)) + (o.cosine ? "c" : "") + (o.robust ? "r" : "") +
                      std::to_string(o.starts) + "\n";
    for (const std::string& name : o.grey)
        all += name + "\n";
    for (const FittedModel& candidate : survey.candidates)
        all += candidate.label + "\n" + candidate.model->text.code;
    for (const SurveySubject& subject : subjects) {
        all += subject.surface.name + "\n" + subject.surface.format + "\n";
        for (const Vec3d& seen : subject.data.seen)
            all += shortest(seen.x) + " ";
    }
    return digestOf(all);
}

class SurveyJobs {
public:
    SurveyJobs(Survey& survey, std::vector<SurveySubject>& subjects) : survey_(survey), subjects_(subjects) {}

    [[nodiscard]] std::uint64_t count() const { return subjects_.size() * survey_.candidates.size(); }

    /// In the process that works.
    [[nodiscard]] std::string done(std::uint64_t job) const
    {
        const FittedModel& candidate = survey_.candidates[job % survey_.candidates.size()];
        FitOptions own = survey_.options;
        own.fixed = candidate.fixed;
        const auto fit = fitModel(*candidate.model, subjects_[job / survey_.candidates.size()].data, own);
        return fit ? std::string(isFitted) + recordOf(*fit) : std::string(isUnfit);
    }

    /// Of job `job`, whose turn it is; false where the text is nothing that done() says.
    bool take(std::uint64_t job, std::string_view said)
    {
        if (job >= count())
            return false;
        SurveyedSurface& surface = subjects_[job / survey_.candidates.size()].surface;
        const FittedModel& candidate = survey_.candidates[job % survey_.candidates.size()];
        std::optional<FitResult> fit;
        if (said.starts_with(isFitted)) {
            fit = fitFromRecord(said.substr(isFitted.size()));
            if (!fit)
                return false;
        } else if (said.starts_with(hasFailed))
            survey_.skipped.push_back(surface.name + " with " + candidate.label + ": " +
                                      std::string(said.substr(hasFailed.size())));
        else if (said != isUnfit)
            return false;
        surface.fits.push_back(std::move(fit));
        return true;
    }

private:
    Survey& survey_;
    std::vector<SurveySubject>& subjects_;
};

/// Where the survey keeps what is done, if it does.
Result<std::optional<Journal>> journalOf(const SurveyRun& run, const std::string& digest, SurveyJobs& jobs)
{
    if (run.journal.empty())
        return std::optional<Journal>();
    Journal::Form form;
    form.head = "reflectance fits 1 " + digest + "\n";
    form.foreign = "holds the fits of other surfaces or options, or was damaged; name another file, or remove this one";
    form.isOurs = [&](std::uint64_t number, std::string_view line) {
        const std::string start = std::to_string(number) + "\t";
        return line.starts_with(start) && jobs.take(number, line.substr(start.size()));
    };
    auto journal = Journal::open(run.journal, form);
    return journal ? Result<std::optional<Journal>>(std::optional(*std::move(journal))) : journal.error();
}

Result<void> lead(SurveyJobs& jobs, std::optional<Journal>& journal, Crew& crew, Progress* progress)
{
    JobList list;
    list.first = journal ? journal->lines() : 0;
    list.end = jobs.count();
    list.text = [](std::uint64_t job) { return std::to_string(job); };
    list.take = [&](std::uint64_t job, const JobOutcome& outcome) -> Result<void> {
        const std::string said = outcome.failure.empty() ? outcome.result : std::string(hasFailed) + outcome.failure;
        jobs.take(job, said);
        if (progress)
            progress->done = static_cast<double>(job + 1) / static_cast<double>(jobs.count());
        return journal ? journal->append(std::to_string(job) + "\t" + said + "\n") : Result<void>();
    };
    const auto ran = Foreman(crew).run(list, [&] { return progress && progress->cancel; });
    if (!ran)
        return ran.error();
    return *ran ? Result<void>() : Error{"stopped"};
}

} // namespace

Result<void> fitAll(Survey& survey, std::vector<SurveySubject> subjects, const SurveyRun& run, Progress* progress)
{
    SurveyJobs jobs(survey, subjects);
    const auto work = [&](std::string_view job, Progress&) {
        return jobs.done(static_cast<std::uint64_t>(parseInteger(job).value_or(0)));
    };
    auto ran = withCrew(handsFor(run.workers), work, [&](Crew& crew) -> Result<void> {
        auto journal = journalOf(run, digestOfInputs(survey, subjects), jobs);
        return journal ? lead(jobs, *journal, crew, progress) : journal.error();
    });
    if (!ran)
        return ran;
    for (SurveySubject& subject : subjects)
        survey.surfaces.push_back(std::move(subject.surface));
    return {};
}

} // namespace reflectance
