// `inspect`: what the reader found in a mesh file and what it repaired.
#include "app/cli/report.h"
#include "app/cli/verbs.h"
#include "core/base/text.h"
#include "core/geometry/load.h"
#include "core/geometry/topology.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

namespace reflectance::cli {
namespace {

struct Options {
    std::string mesh;
    std::string json;
    LoadOptions load;
    bool topology = false;
};

nlohmann::ordered_json list(const Vec3d& v)
{
    return {v.x, v.y, v.z};
}

nlohmann::ordered_json described(const MeshReport& report)
{
    nlohmann::ordered_json reasons = nlohmann::ordered_json::array();
    for (const DroppedFaces& dropped : report.dropped)
        reasons.push_back({{"reason", dropped.reason}, {"count", dropped.count}});
    nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
    for (const MeshWarning& warning : report.warnings)
        warnings.push_back({{"line", warning.line}, {"text", warning.text}});
    return {{"format", report.format},
            {"triangles", report.triangles},
            {"vertices", report.fileVertices},
            {"area", report.area},
            {"dropped", report.droppedFaces()},
            {"dropped_reasons", reasons},
            {"degenerate_triangles", report.degenerateTriangles},
            {"faces", report.fileFaces},
            {"unused_vertices", report.unusedVertices},
            {"drawn_vertices", report.meshVertices},
            {"bounds", {{"low", list(report.lowest)}, {"high", list(report.highest)}}},
            {"normals",
             {{"from_file", report.cornersWithFileNormal},
              {"missing", report.cornersWithoutNormal},
              {"bad", report.cornersWithBadNormal},
              {"computed", report.cornersWithComputedNormal}}},
            {"flipped_triangles", report.flippedTriangles},
            {"seconds",
             {{"read", report.readSeconds},
              {"triangulate", report.triangulateSeconds},
              {"normals", report.normalsSeconds}}},
            {"warnings", warnings},
            {"notes", report.notes}};
}

nlohmann::ordered_json described(const TopologySummary& topology)
{
    return {{"closed", topology.isClosed()},
            {"components", topology.components},
            {"boundary_edges", topology.boundaryEdges},
            {"boundary_loops", topology.boundaryLoops},
            {"non_manifold_edges", topology.nonManifoldEdges},
            {"winding_conflicts", topology.windingConflicts},
            {"separated_triangles", topology.separatedTriangles},
            {"vertices", topology.vertices},
            {"edges", topology.edges},
            {"euler_characteristic", topology.eulerCharacteristic()}};
}

std::string text(const Vec3d& v)
{
    return "(" + general(v.x, 6) + ", " + general(v.y, 6) + ", " + general(v.z, 6) + ")";
}

std::string milliseconds(double seconds)
{
    return general(1e3 * seconds, 3) + " ms";
}

void print(const MeshReport& r)
{
    std::cout << "  format     " << r.format << "\n  file       " << r.fileVertices << " vertices (" << r.unusedVertices
              << " unused), " << r.fileFaces << " faces\n  drawn      " << r.triangles << " triangles, "
              << r.meshVertices << " vertices after splitting at creases\n  area       " << general(r.area, 9)
              << "\n  bounds     " << text(r.lowest) << " .. " << text(r.highest) << "\n  normals    "
              << r.cornersWithFileNormal << " corners from the file, " << r.cornersWithComputedNormal << " computed ("
              << r.cornersWithoutNormal << " missing, " << r.cornersWithBadNormal << " bad)\n  left out   "
              << r.droppedFaces() << " faces, " << r.degenerateTriangles
              << " triangles without area\n  time       read " << milliseconds(r.readSeconds) << ", triangulate "
              << milliseconds(r.triangulateSeconds) << ", normals " << milliseconds(r.normalsSeconds) << '\n';
    for (const DroppedFaces& dropped : r.dropped)
        std::cout << "  dropped    " << dropped.count << ": " << dropped.reason << '\n';
    for (const MeshWarning& warning : r.warnings)
        std::cout << "  warning    " << (warning.line > 0 ? "line " + std::to_string(warning.line) + ": " : "")
                  << warning.text << '\n';
    for (const std::string& note : r.notes)
        std::cout << "  note       " << note << '\n';
}

void print(const TopologySummary& t)
{
    std::cout << "  topology   " << (t.isClosed() ? "closed, " : "open, ") << t.components
              << (t.components == 1 ? " piece" : " pieces") << ", Euler characteristic " << t.eulerCharacteristic()
              << "\n  edges      " << t.edges << ", of them " << t.boundaryEdges << " on a boundary ("
              << t.boundaryLoops << " loops), " << t.nonManifoldEdges << " non-manifold, " << t.windingConflicts
              << " wound in conflict\n";
}

int run(const Options& options)
{
    const auto loaded = loadStockOrFile(options.mesh, options.load);
    if (!loaded)
        return refused(loaded.error());
    std::optional<Topology> topology;
    if (options.topology)
        topology.emplace(*loaded.value().mesh);
    nlohmann::ordered_json report = described(loaded.value().report);
    if (topology)
        report["topology"] = described(topology->summary());
    if (options.json.empty()) {
        std::cout << options.mesh << '\n';
        print(loaded.value().report);
        if (topology)
            print(topology->summary());
    }
    const auto written = writeReport(options.json, report);
    return written ? Done : refused(written.error());
}

} // namespace

void addInspect(CLI::App& program, int& exitCode)
{
    auto options = std::make_shared<Options>();
    CLI::App* verb = program.add_subcommand("inspect", "What the reader found in a mesh and what it repaired");
    verb->add_option("mesh", options->mesh,
                     "an OBJ, PLY, OFF or STL file, or a mesh of the program (" + joined(stockMeshNames()) + ")")
        ->required();
    verb->add_flag("--topology", options->topology, "also pieces, boundaries and edges with more than two triangles");
    verb->add_flag("--smooth", options->load.recomputeNormals, "compute the normals anew even where the file has some");
    verb->add_option("--crease", options->load.creaseAngleDegrees, "degrees; edges that bend by more stay sharp")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 180.0));
    verb->add_option("--json", options->json, "as JSON, to a file or - for standard output");
    verb->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace reflectance::cli
