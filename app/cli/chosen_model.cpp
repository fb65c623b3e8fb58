#include "app/cli/chosen_model.h"

#include "core/reflectance/own_model.h"

#include <CLI/CLI.hpp>

namespace reflectance::cli {

std::vector<CLI::Option*> addModelChoice(CLI::App& verb, ModelChoice& choice, const std::string& about)
{
    CLI::Option* id = verb.add_option("--model", choice.id, about + "; 'reflectance models' lists them");
    if (!choice.id.empty())
        id->capture_default_str();
    id->each([&choice](const std::string&) { choice.isGiven = true; });
    return {id, verb.add_option("--model-file", choice.file, "a model of your own (.glsl) instead")};
}

Result<std::shared_ptr<const Model>> chosenModel(const ModelChoice& choice)
{
    if (!choice.file.empty())
        return choice.isGiven
                   ? Result<std::shared_ptr<const Model>>(Error{"--model-file brings its model; leave --model out"})
                   : readOwnModel(choice.file);
    if (choice.id.empty())
        return Error{"name a model with --model ID, which 'reflectance models' lists, or with --model-file FILE.glsl"};
    const auto found = findModel(choice.id);
    if (!found)
        return found.error();
    return std::shared_ptr<const Model>(*found, [](const Model*) {}); // the catalogue's
}

Result<std::vector<double>> valuesFrom(const ModelText& model, const std::vector<std::string>& assignments,
                                       const std::string& flag)
{
    ParameterValues values;
    for (const std::string& assignment : assignments)
        if (const auto set = setParameter(model, assignment, values); !set)
            return Error{flag + " " + assignment + ": " + set.error().message};
    return flatValues(model, values);
}

} // namespace reflectance::cli
