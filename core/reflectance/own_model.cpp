#include "core/reflectance/own_model.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/reflectance/walked/walker.h"

#include <cctype>
#include <filesystem>

namespace reflectance {
namespace {

using walked::Tree;
using walked::Walker;

template <class T> void shadeWalking(const void* text, const double* values, const ShadeBatch<T>& batch)
{
    Walker<T> walker(*static_cast<const Tree*>(text), values);
    walker.measured = batch.measured;
    for (std::size_t i = 0; i < batch.count; ++i) {
        walker.lightDisc = batch.lightDisc[i];
        const Vec3<T> value = walker.shade(batch.N[i], batch.L[i], batch.V[i], batch.I[i]);
        batch.sum.x[i] += value.x;
        batch.sum.y[i] += value.y;
        batch.sum.z[i] += value.z;
    }
}

template <class T> void environmentWalking(const void* text, const double* values, const EnvironmentBatch<T>& batch)
{
    Walker<T> walker(*static_cast<const Tree*>(text), values);
    walker.surroundings = batch.surroundings;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const Vec3<T> value = walker.shadeEnvironment(batch.N[i], batch.V[i]);
        batch.sum.x[i] += value.x;
        batch.sum.y[i] += value.y;
        batch.sum.z[i] += value.z;
    }
}

template <class T> Kernel<T> walkingKernel(const Tree& tree)
{
    Kernel<T> kernel;
    kernel.shade = {shadeWalking<T>, &tree};
    if (tree.shadeEnvironment >= 0)
        kernel.environment = {environmentWalking<T>, &tree};
    return kernel;
}

/// Small letters, digits and "_".
std::string idFrom(const std::string& stem)
{
    std::string id;
    for (const char c : lowered(stem))
        id += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
    for (const Model& model : catalogue())
        if (model.id() == id)
            return "own_" + id;
    return id.empty() ? "own" : id;
}

/// A loop without an end is met here, for every choice, and not in a picture.
Result<void> endsInTime(const Model& model)
{
    const Tree& tree = *static_cast<const Tree*>(model.walked.get());
    std::vector<std::vector<double>> tried{flatValues(model.text, {})};
    for (const Parameter& parameter : model.text.parameters)
        for (const double choice : parameter.choices)
            tried.push_back(flatValues(model.text, {{parameter.name, {choice}}}));
    const Vec3d N{0.0, 0.0, 1.0}, I{1.0, 1.0, 1.0};
    for (const auto& values : tried)
        for (const Vec3d& L : {Vec3d(0.0, 0.0, 1.0), Vec3d(0.6, 0.0, 0.8), Vec3d(0.0, -0.8, 0.6)}) {
            Walker<double> walker(tree, values.data());
            (void)walker.shade(N, L, {-0.6, 0.0, 0.8}, I);
            if (walker.exhausted())
                return Error{"one evaluation takes more than " + std::to_string(walked::mostSteps) +
                                 " rounds of loops and calls; a picture would take hours",
                             model.text.file};
        }
    return {};
}

} // namespace

Result<Model> walkedModel(ModelText text)
{
    auto tree = walked::treeOf(text);
    if (!tree)
        return tree.error();
    const auto kept = std::make_shared<const Tree>(*std::move(tree));
    Model model;
    model.text = std::move(text);
    model.exact = walkingKernel<double>(*kept);
    model.single = model.lanes = walkingKernel<float>(*kept);
    model.walked = kept;
    return model;
}

Result<std::shared_ptr<const Model>> ownModel(const std::string& path, std::string_view bytes)
{
    static const std::vector<ModelText> earlier = [] {
        std::vector<ModelText> texts;
        for (const Model& known : catalogue())
            texts.push_back(known.text);
        return texts;
    }();
    const std::string stem = std::filesystem::path(path).stem().string();
    auto text = parseModelText(idFrom(stem), bytes, earlier, path);
    if (!text)
        return text.error();
    if (text->name.empty())
        text->name = stem;
    auto model = walkedModel(*std::move(text));
    if (!model)
        return model.error();
    if (const auto ends = endsInTime(*model); !ends)
        return ends.error();
    return std::make_shared<const Model>(*std::move(model));
}

Result<std::shared_ptr<const Model>> readOwnModel(const std::string& path)
{
    auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    return ownModel(path, *bytes);
}

} // namespace reflectance
