#include "core/render/gl/mesh_buffers.h"

#include "core/base/check.h"

#include <algorithm>
#include <vector>

namespace reflectance {
namespace {

/// Two texels of a buffer texture; GL 3.3 has none of three floats.
struct Vertex {
    Vec3f position;
    float spare1;
    Vec3f normal;
    float spare2;
};
static_assert(sizeof(Vertex) == 8 * sizeof(float));

std::vector<Vertex> verticesOf(const Mesh& mesh)
{
    CHECK_EQ(mesh.normals.size(), mesh.positions.size());
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({Vec3f(mesh.positions[i]), 0.0F, Vec3f(mesh.normals[i]), 0.0F});
    return vertices;
}

Result<void> fits(const Gl& gl, const Mesh& mesh)
{
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    const std::size_t texels = std::max(2 * mesh.positions.size(), 3 * mesh.triangles.size());
    if (texels > static_cast<std::size_t>(limit))
        return Error{"a mesh of " + std::to_string(mesh.triangles.size()) +
                     " triangles is larger than OpenGL holds here (" + std::to_string(limit / 3) +
                     "); use --backend cpu"};
    return {};
}

void bind(const Gl& gl, const GlTexture& texture, int unit)
{
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_BUFFER, texture.id());
}

} // namespace

MeshBuffers::MeshBuffers(const Gl& gl) : layout_(gl), vertices_(gl), indices_(gl), vertexTexels_(gl), cornerTexels_(gl)
{
    gl.BindVertexArray(layout_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    gl.BindVertexArray(0);
    bind(gl, vertexTexels_, 0);
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, vertices_.id());
    bind(gl, cornerTexels_, 0);
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, indices_.id());
}

Result<void> MeshBuffers::upload(const Mesh& mesh)
{
    const Gl& gl = layout_.gl();
    if (auto fit = fits(gl, mesh); !fit)
        return fit;
    const std::vector<Vertex> vertices = verticesOf(mesh);
    gl.BindVertexArray(layout_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(Mesh::Triangle)),
                  mesh.triangles.data(), GL_STATIC_DRAW);
    gl.BindVertexArray(0);
    bytes_ = vertices.size() * sizeof(Vertex) + mesh.triangles.size() * sizeof(Mesh::Triangle);
    indexCount_ = static_cast<GLsizei>(3 * mesh.triangles.size());
    return {};
}

void MeshBuffers::draw() const
{
    const Gl& gl = layout_.gl();
    gl.BindVertexArray(layout_.id());
    gl.DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
    gl.BindVertexArray(0);
}

void MeshBuffers::bindVertices(int unit) const
{
    bind(layout_.gl(), vertexTexels_, unit);
}

void MeshBuffers::bindCorners(int unit) const
{
    bind(layout_.gl(), cornerTexels_, unit);
}

} // namespace reflectance
