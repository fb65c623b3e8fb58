// `eval`: a model at given directions, row by row, in any precision.
#include "app/cli/eval_rows.h"
#include "app/cli/verbs.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/reflectance/evaluate.h"
#include "core/reflectance/own_model.h"
#include "core/render/gl/gl_renderer.h"
#include "core/render/pictures/render_picture.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <tuple>

namespace reflectance::cli {
namespace {

struct EvalOptions {
    std::string rows;
    std::string modelFile;
    std::string precision = "double";
    std::string context = "any";
};

constexpr const char* description =
    "A model at given directions. CSV with a header; columns by name: id, model, params, N, L, V, light_rgb and, for "
    "the "
    "mirror, light_radius (degrees). Vectors are three numbers parted by blanks, of any length; several lights are "
    "parted by |. params is name=value;name=value. Output: id,r,g,b - the lecture's factor times the light (cosine "
    "included; the BRDF times pi), linear, unclamped.";

/// Rows of one model with one set of values and one table are evaluated together.
using Group = std::tuple<const Model*, std::vector<double>, std::shared_ptr<const MeasuredTable>>;
using Evaluator = std::function<Result<std::vector<Vec3d>>(const Group&, const std::vector<Observation>&)>;

Result<std::vector<Vec3d>> evaluateGrouped(const std::vector<EvalRow>& rows, const Evaluator& evaluator)
{
    std::map<Group, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < rows.size(); ++i)
        groups[{rows[i].model, rows[i].values, rows[i].table}].push_back(i);
    std::vector<Vec3d> results(rows.size());
    for (const auto& [group, members] : groups) {
        std::vector<Observation> observations;
        for (const std::size_t i : members)
            observations.push_back(rows[i].observation);
        const auto values = evaluator(group, observations);
        if (!values)
            return values.error();
        for (std::size_t k = 0; k < members.size(); ++k)
            results[members[k]] = (*values)[k];
    }
    return results;
}

Result<std::vector<Vec3d>> evaluateInGlsl(const std::vector<EvalRow>& rows, ContextKind kind)
{
    const auto context = openHeadless(kind);
    if (!context)
        return context.error();
    auto renderer = GlRenderer::create((*context)->loader());
    if (!renderer)
        return renderer.error();
    return evaluateGrouped(rows, [&](const Group& group, const std::vector<Observation>& observations) {
        const auto& [model, values, table] = group;
        return renderer->evaluate(*model, values, observations, table);
    });
}

Result<std::vector<Vec3d>> evaluateRows(const std::vector<EvalRow>& rows, const EvalOptions& options)
{
    if (options.precision == "glsl")
        return evaluateInGlsl(rows, contextNamed(options.context));
    const Precision precision = options.precision == "float"  ? Precision::Float
                                : options.precision == "simd" ? Precision::Simd
                                                              : Precision::Double;
    return evaluateGrouped(rows, [precision](const Group& group, const std::vector<Observation>& observations) {
        const auto& [model, values, table] = group;
        return Result(evaluate(*model, values, observations, precision, lookUpsIn(table.get())));
    });
}

int runEval(const EvalOptions& options)
{
    const bool fromInput = options.rows == "-";
    const auto csv =
        fromInput ? Result(std::string(std::istreambuf_iterator<char>(std::cin), {})) : readWholeFile(options.rows);
    if (!csv)
        return refused(csv.error());
    std::shared_ptr<const Model> own;
    if (!options.modelFile.empty()) {
        const auto read = readOwnModel(options.modelFile);
        if (!read)
            return refused(read.error());
        own = *read;
    }
    const auto parsed = parseEvalRows(*csv, fromInput ? "standard input" : options.rows, own);
    if (!parsed)
        return refused(parsed.error());
    const auto results = evaluateRows(parsed->rows, options);
    if (!results)
        return refused(results.error());
    std::string out = "id,r,g,b\n";
    for (std::size_t i = 0; i < results->size(); ++i) {
        const Vec3d& value = (*results)[i];
        out += parsed->rows[i].id + ',' + general(value.x, 17) + ',' + general(value.y, 17) + ',' +
               general(value.z, 17) + '\n';
    }
    std::cout << out << std::flush;
    for (const Error& error : parsed->bad)
        refused(error);
    return parsed->bad.empty() ? Done : BadInput;
}

} // namespace

void addEval(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<EvalOptions>();
    CLI::App* verb = program.add_subcommand("eval", description);
    verb->add_option("--rows", options->rows, "CSV file, or - for standard input")->required();
    verb->add_option("--model-file", options->modelFile,
                     "a model of your own, which rows name by its file's name without the ending");
    verb->add_option("--precision", options->precision, "double, float, simd or glsl")
        ->check(CLI::IsMember({"double", "float", "simd", "glsl"}))
        ->capture_default_str();
    verb->add_option("--context", options->context, "for glsl: any, osmesa or egl")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
    verb->callback([options, &exitCode] { exitCode = runEval(*options); });
}

} // namespace reflectance::cli
