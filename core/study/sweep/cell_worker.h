// Who computes cells, one after the other: keeps the meshes that it has read.
#pragma once

#include "core/render/cpu/thread_limit.h"
#include "core/study/sweep/figures.h"
#include "core/study/sweep/sheet.h"

#include <string>

namespace reflectance {

class CellWorker {
public:
    /// `study` outlives it; `pictures` is a folder, or empty for none.
    CellWorker(const Study& study, std::string pictures, unsigned threads);

    /// Computes a cell and saves its picture; never throws. Worthless when cancelled on the way.
    [[nodiscard]] CellResult computed(const Cell& cell, Progress* progress = nullptr);

private:
    [[nodiscard]] CellResult tried(const Cell& cell, Progress* progress);

    const Study* study_;
    std::string pictures_;
    ThreadLimit limit_;
    KeptMeshes meshes_;
};

} // namespace reflectance
