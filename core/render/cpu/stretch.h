// A share of what a Progress counts.
#pragma once

#include "core/render/progress.h"

namespace reflectance {

/// Its parts add up to the share.
struct Stretch {
    Progress* progress = nullptr;
    double share = 1.0;

    [[nodiscard]] bool cancelled() const { return progress != nullptr && progress->cancel; }
    void advance(double part) const
    {
        if (progress != nullptr)
            progress->done.fetch_add(share * part);
    }
};

} // namespace reflectance
