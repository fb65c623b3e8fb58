// A picture in tiles: pieces that one thread samples and shades while they are in its cache.
#pragma once

#include "core/render/settings.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace reflectance {

/// A tile has at most so many columns and rows of samples.
constexpr int tileEdge = 32;

/// A rectangle of pixels. Its samples lie on one grid, k columns and rows of them in each pixel.
struct Tile {
    int left = 0, top = 0, width = 0, height = 0;
};

class Tiles {
public:
    explicit Tiles(const RenderSettings& settings)
        : settings_(settings), edge_(tileEdge / settings.samplesPerAxis), across_((settings.width + edge_ - 1) / edge_),
          down_((settings.height + edge_ - 1) / edge_)
    {
    }

    [[nodiscard]] int count() const { return across_ * down_; }
    [[nodiscard]] Tile operator[](int i) const
    {
        const int left = i % across_ * edge_;
        const int top = i / across_ * edge_;
        return {left, top, std::min(edge_, settings_.width - left), std::min(edge_, settings_.height - top)};
    }

private:
    RenderSettings settings_;
    int edge_, across_, down_;
};

/// What the samples of a tile met. It is left as it is when made: a big picture has many, most of which see nothing.
struct TileHits {
    static constexpr std::size_t samples = std::size_t{tileEdge} * tileEdge;

    bool any;                                     ///< whether anything was met; else the triangles may not be written
    std::array<double, tileEdge> xs, ys;          ///< image points of the grid's columns and rows; the last repeats
    std::array<std::uint32_t, samples> triangles; ///< or RayScene::nothing; tileEdge in a row of the grid

    [[nodiscard]] std::uint32_t at(int column, int row) const
    {
        return triangles[static_cast<std::size_t>(row) * tileEdge + static_cast<std::size_t>(column)];
    }
};

} // namespace reflectance
