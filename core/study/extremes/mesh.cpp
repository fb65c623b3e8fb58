// H13 to H16 and H62: what a mesh file may hold.
#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/render/cpu/surface_point.h"
#include "core/study/extremes/hazard.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

const std::string oneTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string badNormalsText = oneTriangle + "vn nan 0 1\nvn inf 0 0\nvn 0 0 0\nf 1//1 2//2 3//3\n";
const std::string foldedText = oneTriangle + "f 1 2 3\nf 1 3 2\n";
const std::string withoutAreaText = oneTriangle + "v 2 0 0\nf 1 2 4\nf 1 2 2\nf 1 2 3\n";
const std::string needlesText = "v 0 0 0\nv 1 0 0\nv 1 1e-8 0\nv 1 0 -2e-8\nf 1 2 3\nf 1 4 2\n";
const std::string pentagonText = "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5\n";

Outcome refused(const Error& error)
{
    return {false, error.sentence()};
}

Outcome badNormals(Bench&)
{
    const auto read = readMesh(badNormalsText, "bad.obj");
    if (!read)
        return refused(read.error());
    const auto& normals = read->mesh->normals;
    const bool replaced =
        std::all_of(normals.begin(), normals.end(), [](const Vec3d& N) { return N == Vec3d(0, 0, 1); });
    return {replaced && read->report.cornersWithBadNormal == 3,
            std::to_string(read->report.cornersWithBadNormal) + " counted, normal " + textOf(normals.front())};
}

Outcome foldedFaces(Bench&)
{
    LoadOptions smooth;
    smooth.creaseAngleDegrees = 180.0;
    const auto read = readMesh(foldedText, "folded.obj", smooth);
    if (!read)
        return refused(read.error());
    std::size_t own = 0;
    for (std::size_t t = 0; t < read->mesh->triangles.size(); ++t)
        for (const std::uint32_t v : read->mesh->triangles[t])
            own += read->mesh->normals[v] == Vec3d(0, 0, t == 0 ? 1 : -1) ? 1 : 0;
    return {own == 6, std::to_string(own) + " of 6 corners have their face's normal"};
}

Mesh opposedNormals()
{
    Mesh mesh;
    mesh.name = "opposed";
    mesh.positions = {{-0.5, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.fileVertex = {0, 1, 2};
    mesh.fileVertexCount = 3;
    return mesh;
}

Result<Scene> opposedScene()
{
    auto scene = sceneOfObj(oneTriangle + "f 1 2 3\n");
    if (scene)
        scene->mesh = std::make_shared<Mesh>(opposedNormals());
    return scene;
}

Outcome interpolatedToNothing(Bench&)
{
    const Mesh mesh = opposedNormals();
    const SurfacePoint middle = surfacePoint(mesh, 0, {0, 0, 2}, {0, 0, -1});
    return {middle.N == Vec3d(0, 0, 1), textOf(middle.N)};
}

Outcome withoutArea(Bench&)
{
    const auto read = readMesh(withoutAreaText, "flat.obj");
    const auto tiny = readMesh("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n", "tiny.obj");
    if (!read || !tiny)
        return refused(read ? tiny.error() : read.error());
    const bool holds = read->report.triangles == 1 && tiny->report.triangles == 1 &&
                       read->mesh->normals.front() == Vec3d(0, 0, 1) && tiny->mesh->normals.front() == Vec3d(0, 0, 1);
    return {holds, std::to_string(read->report.triangles) + " and " + std::to_string(tiny->report.triangles) +
                       " drawn, normals " + textOf(read->mesh->normals.front()) + ", " +
                       textOf(tiny->mesh->normals.front())};
}

/// Two needles share an edge, at angles of 1e-8 and 2e-8 at its end: the angles weigh their normals, z and -y. acos of
/// a cosine that rounds to 1 knows neither.
Outcome needles(Bench&)
{
    LoadOptions smooth;
    smooth.creaseAngleDegrees = 180.0;
    const auto read = readMesh(needlesText, "needles.obj", smooth);
    if (!read)
        return refused(read.error());
    const Mesh& mesh = *read->mesh;
    double worst = 0.0;
    Vec3d got;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v)
        if (mesh.fileVertex[v] == 0) {
            got = mesh.normals[v];
            worst = worse(worst, length(got - normalized(Vec3d(0, -2, 1))));
        }
    // The file's decimals round to 2^-53 of the coordinates, the products to a few units more.
    const Outcome outcome = within(worst, 1e-14, "off by");
    return {outcome.holds && got != Vec3d(), textOf(got) + ", " + outcome.found};
}

Outcome bareFiles(Bench&)
{
    const auto polygon = readMesh(pentagonText, "pentagon.obj");
    const auto point = readMesh("v 0 0 0\n", "point.obj");
    const bool holds = polygon && polygon->report.triangles == 3 && polygon->mesh->normals.front() == Vec3d(0, 0, 1) &&
                       !point && !point.error().message.empty();
    return {holds, "pentagon: " + (polygon ? std::to_string(polygon->report.triangles) + " triangles" : "refused") +
                       "; one vertex: " + (point ? "loaded" : "\"" + point.error().message + "\"")};
}

} // namespace

Hazards meshHazards()
{
    return {
        {"H13",
         "normals that are no numbers",
         "OBJ with vn nan 0 1, vn inf 0 0, vn 0 0 0",
         "3 counted, normal 0 0 1: the face's",
         {},
         {},
         badNormals,
         seenMesh(badNormalsText, "A triangle that shines as its face says: the file's normals are no numbers.")},
        {"H14",
         "normals that cancel",
         "two faces back to back, smoothed",
         "6 of 6 corners have their face's normal",
         {},
         {},
         foldedFaces,
         seenMesh(foldedText, "Two faces back to back. Orbit: each side has its own normal, none is black.")},
        {"H14",
         "normals that cancel in between",
         "normals (0,0,1) and (0,0,-1), halfway",
         "0 0 1: the face's",
         {},
         {},
         interpolatedToNothing,
         seenScene(opposedScene, "Normals that point to the front and to the back at the corners: in the middle, where "
                                 "they cancel, the face's own stands in.")},
        {"H15",
         "triangles without area",
         "corners in a line; twice the same; edges of 1e-30",
         "1 and 1 drawn, normals 0 0 1",
         {},
         {},
         withoutArea,
         seenMesh(withoutAreaText, "Of three triangles in the file one has an area. The others are left out, and leave "
                                   "no trace in its normals.")},
        {"H16",
         "weights by small angles",
         "two needles, 1e-8 and 2e-8 wide",
         "(0,-2,1)/sqrt 5 to 1e-14",
         {},
         {},
         needles,
         seenMesh(needlesText, "Two needles, 1e-8 and 2e-8 wide: from any side thinner than a pixel.")},
        {"H62",
         "files with the bare minimum",
         "a pentagon without normals or texture; a single vertex",
         "3 triangles; refused in a sentence",
         {},
         {},
         bareFiles,
         seenMesh(pentagonText, "A pentagon without normals or texture, cut into three triangles.")},
    };
}

} // namespace reflectance
