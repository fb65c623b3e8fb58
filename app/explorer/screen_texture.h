// A picture of 8-bit codes that the window shows: thumbnails, maps, what lies over the view. The window's context must be current.
#pragma once

#include "core/render/headless/headless_context.h"

#include <cstdint>
#include <span>

namespace reflectance::explorer {

/// Where a picture has fewer pixels than the screen: blended, or sharp squares.
enum class Enlarged { Blended, Squares };

class ScreenTexture {
public:
    explicit ScreenTexture(GetProcAddress load, Enlarged enlarged = Enlarged::Blended)
        : load_(load), enlarged_(enlarged)
    {
    }
    ScreenTexture(ScreenTexture&& other) noexcept;
    ScreenTexture& operator=(ScreenTexture&&) = delete;
    ~ScreenTexture();

    /// Rows from the top, three bytes a pixel. Memory is taken anew only when the size changes.
    void show(int width, int height, std::span<const std::uint8_t> rgb);

    [[nodiscard]] unsigned id() const { return id_; } ///< 0 before the first picture

private:
    GetProcAddress load_;
    Enlarged enlarged_;
    unsigned id_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace reflectance::explorer
