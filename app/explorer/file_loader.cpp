#include "app/explorer/file_loader.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/reflectance/own_model.h"
#include "core/scene/scene_file.h"

#include <atomic>
#include <filesystem>
#include <future>
#include <thread>

namespace reflectance::explorer {
namespace {

template <class T> Result<Content> asContent(Result<T> read)
{
    if (!read)
        return read.error();
    return Content(std::move(read).value());
}

} // namespace

struct FileLoader::Job {
    std::string path;
    bool recomputeNormals = false;
    std::atomic<double> done{0.0};
    std::atomic<bool> cancel{false};
    std::promise<Result<Content>> promise;
    std::future<Result<Content>> future = promise.get_future();
    std::jthread thread; // last: joined before what it uses goes

    [[nodiscard]] Result<Content> readMesh()
    {
        LoadOptions options;
        options.recomputeNormals = recomputeNormals;
        options.progress = &done;
        options.cancel = &cancel;
        Result<LoadedMesh> loaded = loadStockOrFile(path, options);
        if (!loaded)
            return loaded.error();
        return Content(std::move(loaded->mesh));
    }

    /// OpenMATERIAL writes JSON too. What is neither is told about as a scene.
    [[nodiscard]] Result<Content> readJson() const
    {
        auto scene = loadScene(path);
        if (scene)
            return asContent(std::move(scene));
        auto table = loadTable(path);
        return table ? asContent(std::move(table)) : Result<Content>(scene.error());
    }

    /// A picture that this program saved restores its session; other linear pictures surround the object.
    [[nodiscard]] Result<Content> readPicture(bool linear) const
    {
        const auto bytes = readWholeFile(path);
        if (!bytes)
            return bytes.error();
        if (linear && !carriesSession(*bytes))
            return asContent(loadEnvironment(path));
        return asContent(keptIn(*bytes, path));
    }

    [[nodiscard]] Result<Content> read()
    {
        const std::string ending = lowered(std::filesystem::path(path).extension().string());
        if (ending == ".json")
            return readJson();
        if (ending == ".png" || ending == ".exr" || ending == ".hdr")
            return readPicture(ending != ".png");
        if (ending == ".glsl")
            return asContent(readOwnModel(path));
        if (ending == ".csv" || ending == ".binary" || ending == ".bsdf" || ending == ".brdf" || ending == ".dat")
            return asContent(loadTable(path));
        return readMesh();
    }

    [[nodiscard]] bool hasEnded() const
    {
        return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }
};

FileLoader::FileLoader(std::function<void()> wake) : wake_(std::move(wake)) {}

FileLoader::~FileLoader()
{
    cancel();
}

void FileLoader::start(const std::string& path, bool recomputeNormals)
{
    cancel();
    job_ = std::make_unique<Job>();
    job_->path = path;
    job_->recomputeNormals = recomputeNormals;
    job_->thread = std::jthread([this, job = job_.get()] {
        job->promise.set_value(job->read());
        wake_();
    });
}

void FileLoader::cancel()
{
    const auto ended = [](const std::unique_ptr<Job>& job) { return job->hasEnded(); };
    std::erase_if(cancelled_, ended);
    if (!job_)
        return;
    job_->cancel = true;
    cancelled_.push_back(std::move(job_));
}

std::optional<Loading> FileLoader::progress() const
{
    if (!job_)
        return std::nullopt;
    return Loading{job_->path, job_->done};
}

std::optional<LoadedFile> FileLoader::take()
{
    if (!job_ || !job_->hasEnded())
        return std::nullopt;
    LoadedFile file{job_->path, job_->future.get()};
    job_.reset();
    return file;
}

void FileLoader::waitFor(std::chrono::milliseconds longest) const
{
    if (job_)
        job_->future.wait_for(longest);
}

} // namespace reflectance::explorer
