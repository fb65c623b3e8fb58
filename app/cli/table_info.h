// `table info`: a measurement described in words and figures.
#pragma once

#include "app/cli/table_options.h"

namespace reflectance::cli {

struct InfoOptions {
    SourceOptions source;
    std::string json;
    std::string map;        ///< CSV of the reciprocity residual; empty: none
    double azimuth = 180.0; ///< degrees
};

/// Prints and writes what the options ask for; returns the exit code.
int runInfo(const InfoOptions& options);

} // namespace reflectance::cli
