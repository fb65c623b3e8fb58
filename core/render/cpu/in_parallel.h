// Loops over all cores, in the arithmetic of the caller.
#pragma once

#include <tbb/parallel_for.h>

namespace reflectance {

/// Calls body(i) for first <= i < last from several threads. Tasks take over the caller's floating-point settings: by
/// themselves they would inherit those of the first to start the threads, and Embree starts them while subnormal numbers
/// are flushed to zero (hazard H72).
template <class Index, class Body> void inParallel(Index first, Index last, const Body& body)
{
    using Context = tbb::task_group_context;
    Context asCaller(Context::bound, Context::default_traits | Context::fp_settings);
    tbb::parallel_for(first, last, body, asCaller);
}

} // namespace reflectance
