#include "core/study/fit/fit_record.h"

#include "core/base/text.h"

#include <algorithm>

namespace reflectance {
namespace {

std::string numbersText(const std::vector<double>& numbers)
{
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : " ") + shortest(number);
    return text;
}

/// Takes field after field; the first that is wrong spoils all that follow.
class Fields {
public:
    explicit Fields(std::string_view record) : fields_(split(record, '\t')) {}

    std::string_view text()
    {
        if (next_ < fields_.size())
            return fields_[next_++];
        isWhole_ = false;
        return {};
    }

    std::vector<double> numbers()
    {
        std::vector<double> found;
        for (const std::string_view word : words(text())) {
            const auto number = parseNumber(word);
            isWhole_ = isWhole_ && number;
            found.push_back(number.value_or(0.0));
        }
        return found;
    }

    double number()
    {
        const auto found = numbers();
        isWhole_ = isWhole_ && found.size() == 1;
        return found.size() == 1 ? found[0] : 0.0;
    }

    std::size_t count()
    {
        const auto found = parseInteger(text());
        isWhole_ = isWhole_ && found && *found >= 0;
        return isWhole_ ? static_cast<std::size_t>(*found) : 0;
    }

    /// A list begins with its length.
    template <class Take> void list(const Take& take)
    {
        for (std::size_t left = count(); left > 0 && isWhole_; --left)
            take();
    }

    [[nodiscard]] bool isAllThere() const { return isWhole_ && next_ == fields_.size(); }

private:
    std::vector<std::string_view> fields_;
    std::size_t next_ = 0;
    bool isWhole_ = true;
};

} // namespace

std::string recordOf(const FitResult& fit)
{
    std::vector<std::string> fields{std::to_string(fit.values.size())};
    for (const auto& [name, numbers] : fit.values)
        fields.insert(fields.end(), {name, numbersText(numbers)});
    fields.push_back(std::to_string(fit.numbers.size()));
    for (const FittedNumber& n : fit.numbers)
        fields.insert(fields.end(), {n.name, shortest(n.value), shortest(n.standardError), n.atBound ? "1" : "0",
                                     n.determined ? "1" : "0"});
    fields.push_back(numbersText(fit.correlations));
    for (const double figure : {fit.rms, fit.relativeRms, fit.weightedRms, fit.aic, fit.bic})
        fields.push_back(shortest(figure));
    fields.push_back(std::to_string(fit.residuals));
    for (const int count : {fit.startsTried, fit.startsThatAgree, fit.iterations})
        fields.push_back(std::to_string(count));
    fields.push_back(std::to_string(fit.warnings.size()));
    for (std::string warning : fit.warnings) {
        std::replace_if(
            warning.begin(), warning.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
        fields.push_back(warning);
    }
    return joined(fields, "\t");
}

std::optional<FitResult> fitFromRecord(std::string_view record)
{
    Fields fields(record);
    FitResult fit;
    fields.list([&] {
        const std::string name(fields.text());
        fit.values[name] = fields.numbers();
    });
    fields.list([&] {
        FittedNumber& number = fit.numbers.emplace_back();
        number.name = fields.text();
        number.value = fields.number();
        number.standardError = fields.number();
        number.atBound = fields.count() == 1;
        number.determined = fields.count() == 1;
    });
    fit.correlations = fields.numbers();
    for (double* figure : {&fit.rms, &fit.relativeRms, &fit.weightedRms, &fit.aic, &fit.bic})
        *figure = fields.number();
    fit.residuals = fields.count();
    for (int* count : {&fit.startsTried, &fit.startsThatAgree, &fit.iterations})
        *count = static_cast<int>(fields.count());
    fields.list([&] { fit.warnings.emplace_back(fields.text()); });
    return fields.isAllThere() ? std::optional(std::move(fit)) : std::nullopt;
}

} // namespace reflectance
