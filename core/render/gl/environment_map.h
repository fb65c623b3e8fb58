// A latitude-longitude picture as a float texture, kept until another picture is asked for.
#pragma once

#include "core/image/image.h"
#include "core/render/gl/gl_objects.h"

#include <cstdint>
#include <memory>

namespace reflectance {

class EnvironmentMap {
public:
    explicit EnvironmentMap(const Gl& gl);

    /// Uploads the picture unless it is the one already there; row 0 of the texture is the picture's top.
    [[nodiscard]] Result<void> show(const std::shared_ptr<const Image>& picture);
    void bindAsInput(int unit) const;
    [[nodiscard]] std::uint64_t uploadedBytes() const { return uploadedBytes_; }

private:
    GlTexture texture_;
    std::shared_ptr<const Image> picture_;
    std::uint64_t uploadedBytes_ = 0;
};

} // namespace reflectance
