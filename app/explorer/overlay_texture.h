// A picture that lies over the view: sharp squares where it has fewer pixels.
#pragma once

#include "core/render/headless/headless_context.h"

#include <cstdint>
#include <functional>
#include <span>

namespace reflectance::explorer {

/// The window's context must be current at every call, the destructor included.
class OverlayTexture {
public:
    OverlayTexture() = default;
    ~OverlayTexture();
    OverlayTexture(const OverlayTexture&) = delete;
    OverlayTexture& operator=(const OverlayTexture&) = delete;

    /// 8-bit RGB, rows from the top.
    void show(int width, int height, std::span<const std::uint8_t> rgb, GetProcAddress load);

    [[nodiscard]] unsigned name() const { return name_; } ///< row 0 of the texture is the highest

private:
    unsigned name_ = 0;
    std::function<void()> remove_;
};

} // namespace reflectance::explorer
