// A measured table as a buffer texture, kept until another table is asked for.
#pragma once

#include "core/render/gl/gl_program.h"
#include "core/scene/measured_table.h"

namespace reflectance {

class TableBuffer {
public:
    explicit TableBuffer(const Gl& gl);

    /// Uploads the table unless it is the one already there, and sets the uniforms of shaders/measured/lookup.glsl for
    /// the program in use. The error says that the driver cannot hold it.
    [[nodiscard]] Result<void> show(const GlProgram& program, const std::shared_ptr<const MeasuredTable>& table,
                                    int unit);

    [[nodiscard]] std::uint64_t uploads() const { return uploads_; }
    [[nodiscard]] std::uint64_t uploadedBytes() const { return uploadedBytes_; }

private:
    [[nodiscard]] Result<void> upload(const TableTexels& texels);

    GlBuffer buffer_;
    GlTexture texture_;
    std::shared_ptr<const MeasuredTable> table_;
    std::uint64_t uploads_ = 0;
    std::uint64_t uploadedBytes_ = 0;
};

} // namespace reflectance
