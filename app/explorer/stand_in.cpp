#include "app/explorer/stand_in.h"

#include "core/geometry/clustered.h"
#include "core/geometry/mesh_bytes.h"

namespace reflectance::explorer {

std::shared_ptr<const Mesh> StandIn::meshFor(const std::shared_ptr<const Mesh>& mesh, bool cameraMoves,
                                             double wholeMilliseconds)
{
    if (of_.lock() != mesh)
        forget(mesh);
    if (auto made = work_.take()) {
        standIn_ = *std::move(made);
        facts_.triangles = standIn_->triangles.size();
        facts_.bytes = bytesOf(*standIn_);
        ++made_;
    }
    const bool wanted = mesh->triangles.size() >= fewestTriangles && wholeMilliseconds > slowMilliseconds;
    if (wanted && !standIn_ && !work_.busy())
        work_.start([mesh](Progress&) -> std::optional<std::shared_ptr<const Mesh>> {
            return std::make_shared<const Mesh>(clustered(*mesh, mostOfStandIn));
        });
    facts_.shown = wanted && cameraMoves && standIn_ != nullptr;
    return facts_.shown ? standIn_ : mesh;
}

void StandIn::forget(const std::shared_ptr<const Mesh>& mesh)
{
    work_.cancel();
    standIn_.reset();
    facts_ = {};
    of_ = mesh;
}

} // namespace reflectance::explorer
