#include "core/reflectance/lobe_form.h"

#include "core/base/text.h"
#include "core/math/counting.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace reflectance {
namespace {

double nothing(double /*n*/)
{
    return 0.0;
}

/// Largest in the limit of large n: that of 1 / (1 + t) - exp(-t), t = n (1 - c), which is 0.20363 at t = 2.5129.
double ofSchlick(double /*n*/)
{
    return 0.2037;
}

/// Falls with k, the power that is taken of the bracket.
double ofTruncated(double n)
{
    return 0.28 / std::exp2(squaringsFor(n));
}

/// Straight lines between 256 steps: step^2 / 8 times the steepest second derivative, 2 n, and what is cut off. Below
/// n = 2 the second derivative has no bound where the lobe ends, and the last step is off by what it measures there.
double ofTable(double n)
{
    const double reach = std::fmin(1.0, 12.0 / n);
    return reach * n / (4.0 * 256.0 * 256.0) + (n < 2.0 ? 2e-4 : 1e-5);
}

constexpr std::array<LobeFormFacts, 6> forms{{
    {LobeForm::Conditioned, "conditioned", "lobe/conditioned.glsl",
     "exp(n log1p(-x)), x = |R - V|^2 / 2: the right one", 0.0, false, nothing},
    {LobeForm::Power, "power", "lobe/power.glsl", "pow of the dot product, as textbooks write it", 0.0, false, nothing},
    {LobeForm::Squarings, "squarings", "lobe/squarings.glsl", "the dot product squared again and again, for whole n",
     0.0, true, nothing},
    {LobeForm::Truncated, "truncated", "lobe/truncated.glsl", "(1 - n (1 - c) / k)^k, k at most 16", 1.0, false,
     ofTruncated},
    {LobeForm::Schlick, "schlick", "lobe/schlick.glsl", "c / (n - n c + c): one division", 1.0, false, ofSchlick},
    {LobeForm::Table, "table", "lobe/table.glsl", "256 steps in sqrt(1 - c), straight lines between", 1.0, false,
     ofTable},
}};

} // namespace

std::span<const LobeFormFacts> lobeForms()
{
    return forms;
}

const LobeFormFacts& factsOf(LobeForm form)
{
    return forms[static_cast<std::size_t>(form)];
}

Result<LobeForm> lobeFormNamed(std::string_view name)
{
    std::vector<std::string> names;
    for (const LobeFormFacts& facts : forms) {
        if (facts.name == name)
            return facts.form;
        names.emplace_back(facts.name);
    }
    return Error{"the lobe has no form '" + std::string(name) + "'; give " + joined(names)};
}

Result<void> checkExponent(LobeForm form, double n)
{
    const LobeFormFacts& facts = factsOf(form);
    if (facts.wholeExponents && n != std::floor(n))
        return Error{"the lobe's form '" + std::string(facts.name) + "' is for whole exponents, and n is " +
                     shortest(n) + "; give a whole n or another form"};
    if (n < facts.smallestExponent)
        return Error{"the lobe's form '" + std::string(facts.name) + "' is for n from " +
                     shortest(facts.smallestExponent) + " on, and n is " + shortest(n) +
                     "; give a larger n or another form"};
    return {};
}

} // namespace reflectance
