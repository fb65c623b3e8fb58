#include "core/study/sweep/cell_worker.h"

#include "core/sensor/picture.h"

#include <exception>
#include <filesystem>
#include <new>
#include <utility>

namespace reflectance {

CellWorker::CellWorker(const Study& study, std::string pictures, unsigned threads)
    : study_(&study), pictures_(std::move(pictures)), limit_(threads)
{
}

CellResult CellWorker::tried(const Cell& cell, Progress* progress)
{
    const auto done = computeCell(cell, study_->folder, meshes_, progress);
    if (!done)
        return {{}, done.error().sentence()};
    if (pictures_.empty() || (progress && progress->cancel))
        return {done->figures, ""};
    const std::string path =
        (std::filesystem::path(pictures_) / ("cell_" + std::to_string(cell.index) + ".png")).string();
    const auto saved = savePicture(path, done->image, done->sensor);
    return saved ? CellResult{done->figures, ""} : CellResult{{}, saved.error().sentence()};
}

CellResult CellWorker::computed(const Cell& cell, Progress* progress)
{
    try {
        return tried(cell, progress);
    } catch (const std::bad_alloc&) {
        return {{}, "out of memory; try a smaller mesh, picture or number of samples"};
    } catch (const std::exception& problem) {
        return {{}, problem.what()};
    }
}

} // namespace reflectance
