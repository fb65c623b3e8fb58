#include "app/explorer/autosave.h"

#include "core/base/file.h"
#include "core/scene/same_scene.h"
#include "core/scene/scene_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

std::chrono::seconds ageOf(const fs::path& file)
{
    std::error_code ignored;
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, ignored);
    return std::chrono::duration_cast<std::chrono::seconds>(age);
}

EarlierSession described(const fs::path& file)
{
    const Result<std::string> text = readWholeFile(file.string());
    return {file.string(), text ? sessionContent(*text) : std::string(), ago(ageOf(file)), false};
}

std::string counted(long count, const std::string& noun)
{
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace

Autosave::Autosave(fs::path folder) : folder_(std::move(folder))
{
    if (folder_.empty())
        return;
    for (SessionSlot& slot : SessionSlot::takeAbandoned(folder_)) {
        EarlierSession session = described(slot.file());
        earlier_.push_back({std::move(slot), std::move(session)});
    }
}

void Autosave::settle(const Scene& scene)
{
    finishWriting();
    seen_ = scene;
    due_.reset();
    if (own_)
        own_->removeFile();
}

void Autosave::watch(const Scene& scene, Clock::time_point now)
{
    if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        note(writing_.get());
    if (folder_.empty())
        return;
    if (!seen_ || *seen_ != scene) {
        seen_ = scene;
        due_ = due_.value_or(now + pause); // the first change counts: a long drag is kept while it lasts
    }
    if (!due_ || now < *due_ || writing_.valid())
        return;
    due_.reset();
    write(scene);
}

double Autosave::secondsUntilWrite(Clock::time_point now) const
{
    constexpr double never = std::numeric_limits<double>::infinity(), lookAgain = 0.1;
    if (writing_.valid())
        return lookAgain;
    return due_ ? std::chrono::duration<double>(*due_ - now).count() : never;
}

void Autosave::write(const Scene& scene)
{
    if (!own_) {
        Result<SessionSlot> slot = SessionSlot::takeFree(folder_);
        if (!slot)
            return note(slot.error());
        own_ = std::move(slot).value();
    }
    writing_ = std::async(std::launch::async, [file = own_->file().string(), scene] { return saveScene(scene, file); });
}

void Autosave::note(const Result<void>& written)
{
    if (!written && !failing_)
        problem_ = written.error();
    failing_ = !written;
}

void Autosave::finishWriting()
{
    if (writing_.valid())
        note(writing_.get());
}

std::optional<Error> Autosave::takeProblem()
{
    return std::exchange(problem_, std::nullopt);
}

std::vector<EarlierSession> Autosave::earlier() const
{
    std::vector<EarlierSession> sessions;
    for (const Earlier& one : earlier_)
        sessions.push_back(one.session);
    return sessions;
}

std::vector<Autosave::Earlier>::iterator Autosave::find(const std::string& file)
{
    return std::find_if(earlier_.begin(), earlier_.end(), [&](const Earlier& one) { return one.session.file == file; });
}

bool Autosave::offers(const std::string& file) const
{
    return std::any_of(earlier_.begin(), earlier_.end(), [&](const Earlier& one) { return one.session.file == file; });
}

void Autosave::dismiss(const std::string& file)
{
    if (const auto found = find(file); found != earlier_.end())
        found->session.dismissed = true;
}

void Autosave::adopt(const std::string& file, const Scene& replaced, const Scene& restored)
{
    finishWriting();
    if (due_)
        write(replaced);
    finishWriting();
    const auto found = find(file);
    if (found == earlier_.end())
        return;
    std::optional<SessionSlot> before = std::exchange(own_, std::move(found->slot));
    earlier_.erase(found);
    std::error_code ignored;
    if (before && fs::exists(before->file(), ignored)) {
        EarlierSession session = described(before->file());
        session.dismissed = true; // it was just given up: in the menu, but not offered at once
        earlier_.insert(earlier_.begin(), {*std::move(before), std::move(session)});
    }
    seen_ = restored;
    due_.reset();
}

void Autosave::end()
{
    finishWriting();
    if (own_)
        own_->removeFile();
    for (const Earlier& one : earlier_)
        if (one.session.dismissed)
            one.slot.removeFile();
    own_.reset();
    earlier_.clear();
    due_.reset();
}

std::string sessionContent(const std::string& text)
{
    const nlohmann::json scene = nlohmann::json::parse(text, nullptr, false);
    const auto at = [&](const char* place) {
        const nlohmann::json::json_pointer pointer(place);
        return scene.contains(pointer) ? scene[pointer] : nlohmann::json();
    };
    const nlohmann::json mesh = at("/mesh"), model = at("/surface/model"), lights = at("/lights");
    if (!mesh.is_string() || !model.is_string() || !lights.is_array())
        return {};
    return fs::path(mesh.get<std::string>()).stem().string() + ", " + model.get<std::string>() + ", " +
           counted(static_cast<long>(lights.size()), "light");
}

std::string ago(std::chrono::seconds age)
{
    const long minutes = static_cast<long>(age.count()) / 60;
    if (minutes < 1)
        return "just now";
    if (minutes < 60)
        return counted(minutes, "minute") + " ago";
    if (minutes < 48 * 60)
        return counted(minutes / 60, "hour") + " ago";
    return counted(minutes / (24 * 60), "day") + " ago";
}

} // namespace reflectance::explorer
