#include "core/render/cpu/vertex_shading.h"

#include "core/render/cpu/pixel_runs.h"

#include <numeric>

namespace reflectance {
namespace {

/// The mesh's vertices as if each were the only sample of a pixel of its own, normals times `side`.
ViewSamples vertexSamples(const Mesh& mesh, const Vec3d& eye, double side)
{
    ViewSamples vertices;
    const std::size_t count = mesh.positions.size();
    vertices.settings = {static_cast<int>(count), 1, 1};
    vertices.eye = eye;
    vertices.firstOfPixel.resize(count + 1);
    std::iota(vertices.firstOfPixel.begin(), vertices.firstOfPixel.end(), 0U);
    vertices.triangle.assign(count, 0U);
    for (std::size_t i = 0; i < count; ++i) {
        vertices.Px.push_back(mesh.positions[i].x);
        vertices.Py.push_back(mesh.positions[i].y);
        vertices.Pz.push_back(mesh.positions[i].z);
        vertices.Nx.push_back(side * mesh.normals[i].x);
        vertices.Ny.push_back(side * mesh.normals[i].y);
        vertices.Nz.push_back(side * mesh.normals[i].z);
    }
    return vertices;
}

/// Areas of the triangles that P makes with the edges, over the triangle's own: they sum to 1 where P lies on it.
Vec3d barycentrics(const Vec3d& P, const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    const Vec3d normal = cross(b - a, c - a);
    const double area = dot(normal, normal);
    const double v = dot(cross(P - a, c - a), normal) / area;
    const double w = dot(cross(b - a, P - a), normal) / area;
    return {1.0 - v - w, v, w};
}

/// The colours of the mesh's vertices, seen from its outside and from its inside.
class VertexColors {
public:
    VertexColors(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic)
        : samples_(samples), mesh_(*scene.mesh),
          outside_(shadeSamples(vertexSamples(mesh_, samples.eye, 1.0), scene, arithmetic)),
          inside_(shadeSamples(vertexSamples(mesh_, samples.eye, -1.0), scene, arithmetic))
    {
    }

    [[nodiscard]] Vec3d at(std::size_t sample) const
    {
        const Mesh::Triangle& triangle = mesh_.triangles[samples_.triangle[sample]];
        const Vec3d P{samples_.Px[sample], samples_.Py[sample], samples_.Pz[sample]};
        const Vec3d N{samples_.Nx[sample], samples_.Ny[sample], samples_.Nz[sample]};
        const Vec3d weights =
            barycentrics(P, mesh_.positions[triangle[0]], mesh_.positions[triangle[1]], mesh_.positions[triangle[2]]);
        const Vec3d outward = weights.x * mesh_.normals[triangle[0]] + weights.y * mesh_.normals[triangle[1]] +
                              weights.z * mesh_.normals[triangle[2]];
        const Image& colors = dot(outward, N) >= 0.0 ? outside_ : inside_;
        return weights.x * color(colors, triangle[0]) + weights.y * color(colors, triangle[1]) +
               weights.z * color(colors, triangle[2]);
    }

private:
    static Vec3d color(const Image& colors, std::uint32_t vertex)
    {
        const std::size_t first = std::size_t{3} * vertex;
        return {colors.rgb[first], colors.rgb[first + 1], colors.rgb[first + 2]};
    }

    const ViewSamples& samples_;
    const Mesh& mesh_;
    Image outside_, inside_;
};

} // namespace

Image shadePerVertex(const ViewSamples& samples, const Scene& scene, const Arithmetic& arithmetic)
{
    const VertexColors colors(samples, scene, arithmetic);
    Image image(samples.settings.width, samples.settings.height);
    const auto sum = [&](std::size_t first, std::span<Vec3d> sums) {
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (std::size_t s = samples.firstOfPixel[first + i]; s < samples.firstOfPixel[first + i + 1]; ++s)
                sums[i] += colors.at(s);
    };
    shadePixelRuns<double>(samples, {0, image.height}, scene, {}, sum, image);
    return image;
}

} // namespace reflectance
