// A coarse stand-in for a big mesh while the camera moves, where a whole picture takes too long to follow the hand.
#pragma once

#include "app/explorer/worker.h"
#include "core/geometry/mesh.h"

#include <cstddef>
#include <memory>

namespace reflectance::explorer {

/// What is known of the stand-in, for the status line.
struct StandInFacts {
    std::size_t triangles = 0; ///< 0: there is none
    std::size_t bytes = 0;     ///< that it takes in memory; on the graphics card it takes about half of that
    bool shown = false;        ///< the last picture shows it
};

class StandIn {
public:
    /// Smaller meshes are drawn as they are: what they cost is not their triangles.
    static constexpr std::size_t fewestTriangles = 200000;
    /// A quarter of that: then both lie on the graphics card (core/render/gl/uploaded_meshes.h).
    static constexpr std::size_t mostOfStandIn = 50000;
    static constexpr double slowMilliseconds = 50.0; ///< of a whole picture: a stand-in is worth it beyond

    explicit StandIn(std::function<void()> wake) : work_(std::move(wake)) {}

    /// The mesh to draw: the stand-in while the camera moves, if there is one and whole pictures are slow; else the mesh.
    /// Begins to make a stand-in, on another thread, for a big mesh whose pictures are slow.
    [[nodiscard]] std::shared_ptr<const Mesh> meshFor(const std::shared_ptr<const Mesh>& mesh, bool cameraMoves,
                                                      double wholeMilliseconds);

    [[nodiscard]] const StandInFacts& facts() const { return facts_; }
    [[nodiscard]] std::size_t made() const { return made_; } ///< how many were made so far

private:
    void forget(const std::shared_ptr<const Mesh>& mesh);

    Worker<std::shared_ptr<const Mesh>> work_;
    std::weak_ptr<const Mesh> of_; ///< what it stands for, or will
    std::shared_ptr<const Mesh> standIn_;
    StandInFacts facts_;
    std::size_t made_ = 0;
};

} // namespace reflectance::explorer
