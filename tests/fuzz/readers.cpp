#include "tests/fuzz/readers.h"

#include "core/image/picture_file.h"
#include "core/reflectance/own_model.h"
#include "core/scene/kept_picture.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/curve_readers.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/table_readers.h"

#include <algorithm>
#include <iterator>

namespace reflectance::fuzz {
namespace {

Outcome refused(const Error& error)
{
    const std::string broken = brokenPromise(error);
    return {false, broken.empty() ? "" : broken + ": " + error.sentence()};
}

template <const char* name> Outcome readMeshNamed(std::string_view bytes)
{
    const auto mesh = readMesh(bytes, name);
    return mesh ? Outcome{true, brokenPromise(*mesh, bytes.size())} : refused(mesh.error());
}

Outcome readPicture(std::string_view bytes)
{
    const auto picture = decodedPicture(bytes, "a.picture");
    return picture ? Outcome{true, brokenPromise(picture->image, bytes.size())} : refused(picture.error());
}

/// Files that a scene names are looked for where there are none: the fuzzer reads what it is given and nothing else.
Outcome readScene(std::string_view bytes)
{
    const auto scene = parseScene(bytes, "a.json", "/nonexistent");
    return scene ? Outcome{true, brokenPromise(*scene)} : refused(scene.error());
}

Outcome readKept(std::string_view bytes)
{
    const auto kept = keptIn(bytes, "/nonexistent/a.picture");
    return kept ? Outcome{true, brokenPromise(kept->scene)} : refused(kept.error());
}

Outcome readSession(std::string_view bytes)
{
    const auto kept = parseKept(bytes, "a.png", "/nonexistent");
    return kept ? Outcome{true, brokenPromise(kept->scene)} : refused(kept.error());
}

Outcome readRows(std::string_view bytes)
{
    const auto rows = cli::parseEvalRows(bytes, "a.csv");
    return rows ? Outcome{true, brokenPromise(*rows)} : refused(rows.error());
}

Outcome readModel(std::string_view bytes)
{
    const auto model = ownModel("a.glsl", bytes);
    return model ? Outcome{true, brokenPromise(**model)} : refused(model.error());
}

constexpr char obj[] = "a.obj", ply[] = "a.ply", off[] = "a.off", stl[] = "a.stl";

} // namespace

const std::vector<Reader>& readers()
{
    static const std::vector<Reader> all = [] {
        std::vector<Reader> tables = tableReaders();
        std::vector<Reader> readers{{"obj", readMeshNamed<obj>, objSeeds()}, {"ply", readMeshNamed<ply>, plySeeds()},
                                    {"off", readMeshNamed<off>, offSeeds()}, {"stl", readMeshNamed<stl>, stlSeeds()},
                                    {"scene", readScene, sceneSeeds()},      {"png", readPicture, pngSeeds()},
                                    {"exr", readPicture, exrSeeds()},        {"pfm", readPicture, pfmSeeds()},
                                    {"hdr", readPicture, hdrSeeds()},        {"rows", readRows, rowSeeds()},
                                    {"model", readModel, modelSeeds()},      {"session", readSession, sessionSeeds()},
                                    {"kept", readKept, keptSeeds()}};
        std::vector<Reader> curves = curveReaders();
        for (std::vector<Reader>* more : {&tables, &curves})
            readers.insert(readers.end(), std::make_move_iterator(more->begin()), std::make_move_iterator(more->end()));
        return readers;
    }();
    return all;
}

const Reader* findReader(std::string_view name)
{
    const auto found =
        std::find_if(readers().begin(), readers().end(), [&](const Reader& r) { return r.name == name; });
    return found == readers().end() ? nullptr : &*found;
}

} // namespace reflectance::fuzz
