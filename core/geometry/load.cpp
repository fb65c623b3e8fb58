#include "core/geometry/load.h"

#include "core/base/embedded.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/geometry/assemble.h"
#include "core/geometry/readers.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>

namespace reflectance {
namespace {

constexpr std::string_view stockFolder = "meshes/";
constexpr std::string_view stockExtension = ".obj";

class Stopwatch {
public:
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - start_;
        start_ = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string extensionOf(const std::string& name)
{
    const std::string extension = std::filesystem::path(name).extension().string();
    return extension.empty() ? extension : lowered(extension).substr(1);
}

/// "1 triangle", "2 triangles", "0 vertices".
std::string counted(std::size_t count, const std::string& one, const std::string& many = "")
{
    return std::to_string(count) + " " + (count == 1 ? one : (many.empty() ? one + "s" : many));
}

Error noFaces(const MeshReport& report, const std::string& file)
{
    std::string text = "has no usable faces";
    for (const DroppedFaces& dropped : report.dropped)
        text += "; " + dropped.reason + " (" + counted(dropped.count, "time") + ")";
    if (report.degenerateTriangles > 0)
        text += "; " + counted(report.degenerateTriangles, "triangle") + " without area";
    if (report.fileFaces == 0)
        text += ": it lists " + counted(report.fileVertices, "vertex", "vertices") + " and no faces";
    return {text + "; choose a mesh with triangles or polygons", file};
}

/// Says why a mesh looks faceted when its file asks for it.
void noteFlatShading(const CornerNormals& normals, MeshReport& report)
{
    const auto isFlat = [](const Mesh::Triangle& n) { return n[0] == n[1] && n[1] == n[2]; };
    constexpr std::size_t fewTriangles = 100; // a cube has flat faces by nature
    if (normals.corners.size() >= fewTriangles && report.cornersWithFileNormal == 3 * normals.corners.size() &&
        std::all_of(normals.corners.begin(), normals.corners.end(), isFlat))
        report.notes.emplace_back(
            "the file gives every face one normal, so the surface looks faceted; computing the normals "
            "anew (--smooth) rounds it");
}

void warnOfNormals(const MeshReport& report, Warnings& warnings)
{
    if (report.cornersWithBadNormal > 0)
        warnings.add("normals that are zero, not finite or not in the file were computed anew", 0,
                     counted(report.cornersWithBadNormal, "corner"));
    if (report.cornersWithoutNormal > 0 && report.cornersWithFileNormal > 0)
        warnings.add("some faces have no normals; they were computed", 0,
                     counted(report.cornersWithoutNormal, "corner"));
    if (report.flippedTriangles > 0)
        warnings.add("triangles wound against their normals were turned over", 0,
                     counted(report.flippedTriangles, "triangle"));
}

/// From what a reader found to the mesh. Every step gives back what it has used up: of a large mesh little is held twice.
Result<LoadedMesh> meshOf(PolygonSoup soup, ReadContext& context, const LoadOptions& options, MeshReport report)
{
    Stopwatch watch;
    report.format = soup.format;
    report.notes = soup.notes;
    context.stepBegins = 0.4;
    context.stepEnds = 0.6;
    auto list = trianglesOf(soup, context, report);
    if (!list)
        return list.error();
    if (list->vertices.empty())
        return noFaces(report, context.file);
    report.triangulateSeconds = watch.lap();
    if (!context.goOn(1.0))
        return context.stopped();

    CornerNormals normals = fileNormals(soup, *list, report, context.threads);
    warnOfNormals(report, context.warnings);
    if (options.recomputeNormals)
        normals = {};
    else
        noteFlatShading(normals, report);
    smoothMissingNormals(soup, *list, options.creaseAngleDegrees, normals, report, context.threads);
    auto mesh = std::make_shared<Mesh>(assembled(soup, *std::move(list), normals, report, context.threads));
    mesh->name = std::filesystem::path(context.file).stem().string();
    report.normalsSeconds = watch.lap();
    report.warnings = context.warnings.list();
    if (options.progress)
        options.progress->store(1.0, std::memory_order_relaxed);
    return LoadedMesh{std::move(mesh), std::move(report)};
}

/// `read` gives the soup.
template <class Read> Result<LoadedMesh> meshFrom(const std::string& name, const LoadOptions& options, const Read& read)
{
    try {
        ReadContext context{name, {}, options.progress, options.cancel, threadsFor(0), 0.0, 0.4};
        Stopwatch watch;
        auto soup = read(context);
        if (!soup)
            return soup.error();
        MeshReport report;
        report.readSeconds = watch.lap();
        return meshOf(*std::move(soup), context, options, std::move(report));
    } catch (const std::bad_alloc&) {
        return Error{"does not fit into the memory; simplify it or close other programs", name};
    }
}

/// Reads OBJ without holding all of the file.
Result<PolygonSoup> soupOfFile(const std::string& path, ReadContext& context)
{
    const auto head = readFileHead(path, headOfFile);
    if (!head)
        return head.error();
    const std::string extension = extensionOf(path);
    if (auto error = whyNoMesh(*head, extension, path))
        return *error;
    constexpr std::uintmax_t largest = std::uintmax_t{4} << 30U; // beyond, readWholeFile says why not
    if (head->fileSize <= largest && isSurelyObj(*head, extension)) {
        auto parts = TextParts::ofFile(path, head->fileSize);
        return parts ? readObj(*std::move(parts), context) : parts.error();
    }
    const auto bytes = readWholeFile(path);
    return bytes ? readSoup(*bytes, extension, context) : bytes.error();
}

} // namespace

std::size_t MeshReport::droppedFaces() const
{
    std::size_t sum = 0;
    for (const DroppedFaces& reason : dropped)
        sum += reason.count;
    return sum;
}

Result<LoadedMesh> readMesh(std::string_view bytes, const std::string& name, const LoadOptions& options)
{
    return meshFrom(name, options, [&](ReadContext& context) { return readSoup(bytes, extensionOf(name), context); });
}

Result<LoadedMesh> loadMesh(const std::string& path, const LoadOptions& options)
{
    return meshFrom(path, options, [&](ReadContext& context) { return soupOfFile(path, context); });
}

std::vector<std::string> stockMeshNames()
{
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embeddedFiles())
        if (file.name.starts_with(stockFolder) && file.name.ends_with(stockExtension))
            names.emplace_back(
                file.name.substr(stockFolder.size(), file.name.size() - stockFolder.size() - stockExtension.size()));
    std::sort(names.begin(), names.end());
    return names;
}

Result<LoadedMesh> loadStockOrFile(const std::string& nameOrPath, const LoadOptions& options)
{
    const std::vector<std::string> names = stockMeshNames();
    if (std::find(names.begin(), names.end(), nameOrPath) != names.end()) {
        const std::string file = std::string(stockFolder) + nameOrPath + std::string(stockExtension);
        return readMesh(embeddedText(file), file, options);
    }
    auto loaded = loadMesh(nameOrPath, options);
    const bool isPlainName = nameOrPath.find_first_of("./") == std::string::npos;
    if (!loaded && isPlainName && !std::filesystem::exists(nameOrPath))
        return Error{"is neither a file nor one of the program's meshes (" + joined(names) + ")", nameOrPath};
    return loaded;
}

} // namespace reflectance
