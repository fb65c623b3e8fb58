// Reads files on another thread, so that the window never waits for a disk. One at a time: a new one replaces the old.
#pragma once

#include "app/explorer/state.h"
#include "core/base/result.h"
#include "core/scene/kept_picture.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace reflectance::explorer {

/// What a file held, told by its ending: .json a scene (or else a measurement), .png a session, .exr and .hdr a session or
/// else an environment, .glsl an own model, those of measurements a table, all else a mesh.
using Content = std::variant<std::shared_ptr<const Mesh>, Scene, Environment, std::shared_ptr<const MeasuredTable>,
                             KeptPicture, std::shared_ptr<const Model>>;

struct LoadedFile {
    std::string path;
    Result<Content> content;
};

class FileLoader {
public:
    /// `wake` is called from the other thread when a file is there.
    explicit FileLoader(std::function<void()> wake);
    ~FileLoader(); ///< cancels, and waits for its threads
    FileLoader(const FileLoader&) = delete;
    FileLoader& operator=(const FileLoader&) = delete;

    /// Of a mesh, `recomputeNormals` smooths the normals even where the file gives some.
    void start(const std::string& path, bool recomputeNormals);
    void cancel(); ///< returns at once; the thread ends by itself

    [[nodiscard]] std::optional<Loading> progress() const; ///< nothing while idle
    [[nodiscard]] std::optional<LoadedFile> take();        ///< the file that was read, once; never a cancelled one
    void waitFor(std::chrono::milliseconds longest) const; ///< returns early when there is something to take

private:
    struct Job;
    std::function<void()> wake_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_; ///< until their threads have ended
};

} // namespace reflectance::explorer
