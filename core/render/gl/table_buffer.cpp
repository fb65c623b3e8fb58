#include "core/render/gl/table_buffer.h"

#include <string>

namespace reflectance {

TableBuffer::TableBuffer(const Gl& gl) : buffer_(gl), texture_(gl) {}

Result<void> TableBuffer::upload(const TableTexels& texels)
{
    const Gl& gl = buffer_.gl();
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (texels.texels() > static_cast<std::size_t>(limit))
        return Error{"a table of " + std::to_string(texels.texels()) +
                     " texels is larger than this driver's buffers (" + std::to_string(limit) + "); use --backend cpu"};
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.numbers.size() * sizeof(float)),
                  texels.numbers.data(), GL_STATIC_DRAW);
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.id());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.id());
    ++uploads_;
    uploadedBytes_ += texels.numbers.size() * sizeof(float);
    return {};
}

Result<void> TableBuffer::show(const GlProgram& program, const std::shared_ptr<const MeasuredTable>& table, int unit)
{
    // Before the upload, which binds: the unit that was active belongs to somebody else.
    buffer_.gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    if (table != table_) {
        table_.reset();
        if (auto done = upload(table->texels); !done)
            return done;
        table_ = table;
    }
    buffer_.gl().BindTexture(GL_TEXTURE_BUFFER, texture_.id());
    const TableTexels& texels = table->texels;
    program.set("tableTexels", unit);
    program.set("tableSystem", texels.system);
    program.set("tableInterpolation", texels.interpolation);
    program.set("tableRows", texels.rows);
    program.set("tableIsMatrix", texels.isMatrix ? 1 : 0);
    program.set("tableCountA", texels.counts[0]);
    program.set("tableCountB", texels.counts[1]);
    program.set("tableCountC", texels.counts[2]);
    return {};
}

} // namespace reflectance
