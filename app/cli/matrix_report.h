// What `matrix` found, as text and as JSON.
#pragma once

#include "app/cli/matrix_object.h"

#include <nlohmann/json_fwd.hpp>
#include <ostream>

namespace reflectance::cli {

struct MatrixFindings {
    std::string sensor, light; ///< as they were named
    Convention convention = Convention::Sensor;
    ColorSystem system;
    std::vector<JudgedSurface> surfaces;
    std::vector<JudgedLight> lights;
    std::vector<CheatPrice> inSpan;     ///< prices under the lights that the primaries can make
    std::vector<CheatPrice> outside;    ///< and under the others; empty if there are none
    std::vector<ObjectPrices> onObject; ///< empty where no object was named
    std::vector<std::string> warnings;
};

void print(std::ostream& out, const MatrixFindings& findings);
[[nodiscard]] nlohmann::ordered_json described(const MatrixFindings& findings);

} // namespace reflectance::cli
