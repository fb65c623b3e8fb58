#include "core/render/cpu/shading_places.h"

#include "core/base/check.h"
#include "core/render/cpu/pixel_runs.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace reflectance {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

Vec3d positionOf(const ViewSamples& samples, std::size_t i)
{
    return {samples.Px[i], samples.Py[i], samples.Pz[i]};
}

Vec3d normalOf(const ViewSamples& samples, std::size_t i)
{
    return {samples.Nx[i], samples.Ny[i], samples.Nz[i]};
}

void append(ViewSamples& places, const Vec3d& P, const Vec3d& N, std::uint32_t triangle)
{
    places.Px.push_back(P.x);
    places.Py.push_back(P.y);
    places.Pz.push_back(P.z);
    places.Nx.push_back(N.x);
    places.Ny.push_back(N.y);
    places.Nz.push_back(N.z);
    places.triangle.push_back(triangle);
}

/// Areas of the triangles that P makes with the edges, over the triangle's own: they sum to 1 where P lies on it.
Vec3d barycentrics(const Vec3d& P, const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    const Vec3d normal = cross(b - a, c - a);
    const double area = dot(normal, normal);
    if (!(area > 0.0))
        return {1.0, 0.0, 0.0};
    const double v = dot(cross(P - a, c - a), normal) / area;
    const double w = dot(cross(b - a, P - a), normal) / area;
    return {1.0 - v - w, v, w};
}

/// The middle one of these samples is the place of all of them.
void choosePlace(PlacedView& view, std::span<const std::uint32_t> together)
{
    const ViewSamples& samples = *view.samples;
    for (const std::uint32_t i : together)
        view.placesOf[i] = static_cast<std::uint32_t>(view.places.count());
    const std::uint32_t middle = together[together.size() / 2];
    append(view.places, positionOf(samples, middle), normalOf(samples, middle), samples.triangle[middle]);
}

/// One place for each pixel's samples, or for those of them that see the same triangle.
void chooseMiddleSamples(PlacedView& view, bool ofEachTriangle)
{
    const ViewSamples& samples = *view.samples;
    view.placesOf.resize(samples.count());
    std::vector<std::uint32_t> left, together;
    for (std::size_t pixel = 0; pixel + 1 < samples.firstOfPixel.size(); ++pixel) {
        left.resize(samples.firstOfPixel[pixel + 1] - samples.firstOfPixel[pixel]);
        std::iota(left.begin(), left.end(), samples.firstOfPixel[pixel]);
        while (!left.empty()) {
            const auto taken = [&](std::uint32_t i) {
                return !ofEachTriangle || samples.triangle[i] == samples.triangle[left.front()];
            };
            together.clear();
            std::copy_if(left.begin(), left.end(), std::back_inserter(together), taken);
            choosePlace(view, together);
            std::erase_if(left, [&](std::uint32_t i) {
                return std::binary_search(together.begin(), together.end(), i);
            });
        }
    }
}

/// The sides of vertices that are seen: a place each.
void chooseVertices(PlacedView& view, const Mesh& mesh)
{
    const ViewSamples& samples = *view.samples;
    std::vector<std::uint32_t> outside(mesh.positions.size(), none);
    std::vector<std::uint32_t> inside(mesh.positions.size(), none);
    for (std::size_t i = 0; i < samples.count(); ++i) {
        const Mesh::Triangle& triangle = mesh.triangles[samples.triangle[i]];
        const auto& [a, b, c] = triangle;
        const Vec3d weights =
            barycentrics(positionOf(samples, i), mesh.positions[a], mesh.positions[b], mesh.positions[c]);
        const Vec3d outward = weights.x * mesh.normals[a] + weights.y * mesh.normals[b] + weights.z * mesh.normals[c];
        const bool seenFromOutside = dot(outward, normalOf(samples, i)) >= 0.0;
        for (const std::uint32_t vertex : triangle) {
            std::uint32_t& place = (seenFromOutside ? outside : inside)[vertex];
            if (place == none) {
                place = static_cast<std::uint32_t>(view.places.count());
                append(view.places, mesh.positions[vertex], (seenFromOutside ? 1.0 : -1.0) * mesh.normals[vertex],
                       samples.triangle[i]);
            }
            view.placesOf.push_back(place);
        }
        for (const double weight : {weights.x, weights.y, weights.z})
            view.weights.push_back(static_cast<float>(weight));
    }
}

void chooseFaces(PlacedView& view, const Mesh& mesh)
{
    const ViewSamples& samples = *view.samples;
    std::vector<std::uint32_t> placeOf(mesh.triangles.size(), none);
    for (std::size_t i = 0; i < samples.count(); ++i) {
        std::uint32_t& place = placeOf[samples.triangle[i]];
        if (place == none) {
            place = static_cast<std::uint32_t>(view.places.count());
            const auto& [a, b, c] = mesh.triangles[samples.triangle[i]];
            const Vec3d centroid = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
            const Vec3d N =
                normalized(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
            const double side = dot(N, samples.eye - centroid) >= 0.0 ? 1.0 : -1.0;
            append(view.places, centroid, side * N, samples.triangle[i]);
        }
        view.placesOf.push_back(place);
    }
}

Vec3f colorAt(const Image& colors, std::uint32_t place)
{
    const float* rgb = &colors.rgb[std::size_t{3} * place];
    return {rgb[0], rgb[1], rgb[2]};
}

/// What a sample shows, from the colours of its places.
Vec3f colorOf(const PlacedView& view, const Image& colors, std::size_t sample)
{
    if (view.place != Place::Vertex)
        return colorAt(colors, view.placesOf[sample]);
    const std::uint32_t* places = &view.placesOf[3 * sample];
    const float* weights = &view.weights[3 * sample];
    return weights[0] * colorAt(colors, places[0]) + weights[1] * colorAt(colors, places[1]) +
           weights[2] * colorAt(colors, places[2]);
}

std::size_t bytesOf(const ViewSamples& samples)
{
    return samples.count() * (6 * sizeof(double) + sizeof(std::uint32_t)) +
           samples.firstOfPixel.size() * sizeof(std::uint32_t);
}

} // namespace

std::size_t PlacedView::shadings() const
{
    return place == Place::Sample ? samples->count() : places.count();
}

std::size_t PlacedView::bytes() const
{
    return bytesOf(*samples) + bytesOf(places) + placesOf.size() * sizeof(std::uint32_t) +
           weights.size() * sizeof(float);
}

PlacedView placedView(std::shared_ptr<const ViewSamples> samples, const Mesh& mesh, Place place)
{
    PlacedView view;
    view.place = place;
    view.samples = std::move(samples);
    view.places.eye = view.samples->eye;
    if (place == Place::Pixel || place == Place::Fragment)
        chooseMiddleSamples(view, place == Place::Fragment);
    else if (place == Place::Vertex)
        chooseVertices(view, mesh);
    else if (place == Place::Face)
        chooseFaces(view, mesh);
    view.places.settings = {static_cast<int>(view.places.count()), 1, 1};
    view.places.firstOfPixel.resize(view.places.count() + 1);
    std::iota(view.places.firstOfPixel.begin(), view.places.firstOfPixel.end(), 0U);
    return view;
}

Image shadePlaces(const PlacedView& view, const Scene& scene, const Arithmetic& arithmetic)
{
    const ViewSamples& samples = *view.samples;
    if (view.place == Place::Sample)
        return shadeSamples(samples, scene, arithmetic);
    const Image colors = shadeSamples(view.places, scene, arithmetic);
    Image image(samples.settings.width, samples.settings.height);
    CHECK_EQ(samples.firstOfPixel.size(), image.pixels() + 1);
    const auto sum = [&](std::size_t first, std::span<Vec3d> sums) {
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (std::size_t s = samples.firstOfPixel[first + i]; s < samples.firstOfPixel[first + i + 1]; ++s)
                sums[i] += Vec3d(colorOf(view, colors, s));
    };
    shadePixelRuns<double>(samples, scene, {}, sum, image);
    return image;
}

} // namespace reflectance
