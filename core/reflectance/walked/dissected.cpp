#include "core/reflectance/walked/dissected.h"

#include "core/base/check.h"
#include "core/reflectance/own_model.h"

#include <map>
#include <mutex>
#include <string>

namespace reflectance::walked {
namespace {

/// More than the catalogue has; an own text that is edited for hours does not fill the memory.
constexpr std::size_t mostKept = 64;

std::shared_ptr<const Dissected> made(const ModelText& text)
{
    auto parts = std::make_shared<Dissected>();
    auto tree = treeOf(text);
    CHECK_EQ(tree.has_value(), true); // a test reads every built-in text; an own one was read before it was used
    parts->tree = *std::move(tree);
    parts->terms = termsOf(parts->tree);
    if (parts->terms.size() < 2)
        return parts;
    for (std::size_t i = 0; i < parts->terms.size(); ++i) {
        std::vector<bool> keep(parts->terms.size(), false);
        keep[i] = true;
        ModelText left = withTerms(text, parts->tree, keep);
        left.becomes.clear(); // what is declared of the whole is not true of a part
        auto model = walkedModel(std::move(left));
        CHECK_EQ(model.has_value(), true);
        parts->alone.push_back(std::make_shared<const Model>(*std::move(model)));
    }
    return parts;
}

} // namespace

std::shared_ptr<const Dissected> dissected(const ModelText& text)
{
    static std::mutex guard;
    static std::map<std::string, std::shared_ptr<const Dissected>> kept;
    const std::string key = text.id + '\n' + text.file + '\n' + text.code;
    const std::lock_guard lock(guard);
    if (const auto known = kept.find(key); known != kept.end())
        return known->second;
    if (kept.size() >= mostKept)
        kept.clear();
    return kept[key] = made(text);
}

} // namespace reflectance::walked
