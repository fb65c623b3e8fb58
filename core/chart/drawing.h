// A chart of a page: the page links it, a file beside it holds it.
#pragma once

#include "core/chart/chart.h"

namespace reflectance {

struct Drawing {
    std::string name; ///< of its file, without ending: "served"
    std::string says; ///< what is seen in it
    Chart chart;
};

} // namespace reflectance
