#include "core/geometry/warnings.h"

namespace reflectance {
namespace {

constexpr std::size_t shownOfEachKind = 3;

} // namespace

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text.substr(0, 20))
        result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > 20 ? "...\"" : "\"");
}

Warnings::Kind& Warnings::find(std::string_view text)
{
    const auto [place, isNew] = places_.try_emplace(std::string(text), kinds_.size());
    if (isNew)
        kinds_.push_back({std::string(text), {}, 0});
    return kinds_[place->second];
}

void Warnings::add(std::string_view kind, long line, std::string_view detail)
{
    Kind& known = find(kind);
    ++known.count;
    if (known.count > shownOfEachKind)
        return;
    std::string text(kind);
    if (!detail.empty())
        text.append(": ").append(detail);
    known.first.push_back({std::move(text), line});
}

void Warnings::append(const Warnings& later, long linesBefore)
{
    for (const Kind& kind : later.kinds_) {
        Kind& known = find(kind.text);
        for (const MeshWarning& warning : kind.first)
            if (known.first.size() < shownOfEachKind)
                known.first.push_back({warning.text, warning.line > 0 ? warning.line + linesBefore : 0});
        known.count += kind.count;
    }
}

std::size_t Warnings::count(std::string_view kind) const
{
    const auto place = places_.find(kind);
    return place == places_.end() ? 0 : kinds_[place->second].count;
}

std::vector<MeshWarning> Warnings::list() const
{
    std::vector<MeshWarning> all;
    for (const Kind& kind : kinds_) {
        all.insert(all.end(), kind.first.begin(), kind.first.end());
        if (kind.count > kind.first.size())
            all.push_back({kind.text + ": " + std::to_string(kind.count - kind.first.size()) + " more", 0});
    }
    return all;
}

} // namespace reflectance
