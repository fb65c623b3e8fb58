#include "core/measured/measurement.h"

namespace reflectance {

const Provenance& provenanceOf(const Measurement& measurement)
{
    return std::visit([](const auto& m) -> const Provenance& { return m.provenance; }, measurement);
}

std::size_t channelsOf(const Measurement& measurement)
{
    return std::visit([](const auto& m) { return m.channels; }, measurement);
}

std::optional<Mat3d> brdfAt(const Measurement& measurement, const Vec3d& L, const Vec3d& V)
{
    return std::visit([&](const auto& m) { return brdfAt(m, L, V); }, measurement);
}

} // namespace reflectance
