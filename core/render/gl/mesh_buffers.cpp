#include "core/render/gl/mesh_buffers.h"

#include "core/base/check.h"

#include <limits>
#include <vector>

namespace reflectance {
namespace {

struct Vertex {
    Vec3f position, normal;
};
static_assert(sizeof(Vertex) == 6 * sizeof(float));

std::vector<Vertex> verticesOf(const Mesh& mesh)
{
    CHECK_EQ(mesh.normals.size(), mesh.positions.size());
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({Vec3f(mesh.positions[i]), Vec3f(mesh.normals[i])});
    return vertices;
}

} // namespace

MeshBuffers::MeshBuffers(const Gl& gl) : layout_(gl), vertices_(gl), indices_(gl)
{
    gl.BindVertexArray(layout_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl.EnableVertexAttribArray(0);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(sizeof(Vec3f)));
    gl.BindVertexArray(0);
}

void MeshBuffers::upload(const Mesh& mesh)
{
    CHECK_LE(mesh.triangles.size(), static_cast<std::size_t>(std::numeric_limits<GLsizei>::max() / 3));
    const Gl& gl = layout_.gl();
    const std::vector<Vertex> vertices = verticesOf(mesh);
    gl.BindVertexArray(layout_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(Mesh::Triangle)),
                  mesh.triangles.data(), GL_STATIC_DRAW);
    gl.BindVertexArray(0);
    indexCount_ = static_cast<GLsizei>(3 * mesh.triangles.size());
}

void MeshBuffers::draw() const
{
    const Gl& gl = layout_.gl();
    gl.BindVertexArray(layout_.id());
    gl.DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
    gl.BindVertexArray(0);
}

} // namespace reflectance
