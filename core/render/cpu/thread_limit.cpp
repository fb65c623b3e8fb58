#include "core/render/cpu/thread_limit.h"

#include <algorithm>
#include <tbb/global_control.h>

namespace reflectance {

struct ThreadLimit::Control {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(unsigned threads)
    : control_(new Control{tbb::global_control(tbb::global_control::max_allowed_parallelism, std::max(1U, threads))})
{
}

ThreadLimit::~ThreadLimit() = default;

} // namespace reflectance
