#include "app/explorer/requests.h"

#include "app/explorer/own_models.h"
#include "app/explorer/pictures.h"
#include "app/explorer/preferences.h"
#include "app/explorer/ui/workbench/page.h"
#include "app/explorer/user_folders.h"
#include "core/base/file.h"
#include "core/scene/scene_file.h"

#include <filesystem>

namespace reflectance::explorer {
namespace {

namespace fs = std::filesystem;

void tell(Session& session, std::string text)
{
    session.state.message = Message{std::move(text), false};
}

void complain(Session& session, const Error& error)
{
    session.state.message = Message{error.sentence(), true};
}

void frame(Session& session)
{
    session.state.scene.camera = framedWithHandles(session.state.scene.camera, session.viewport.view.size);
}

void resetView(Session& session)
{
    session.state.turntable = false;
    session.state.scene.camera = Camera();
    frame(session);
}

/// Out of line: GCC 12 takes what the empty optionals of a temporary hold for uninitialised.
[[gnu::noinline]] void endComparison(Session& session)
{
    static const CompareView nothingCompared;
    session.state.compare = nothingCompared;
}

/// Lights, surface and sensor as the program starts with; the mesh stays. From a hazard's case, the way back.
void resetScene(Session& session)
{
    if (leaveCase(session.state))
        return;
    Scene fresh = defaultScene();
    fresh.mesh = session.state.scene.mesh;
    fresh.meshFile = session.state.scene.meshFile;
    fresh.recomputeNormals = session.state.scene.recomputeNormals;
    session.state.scene = std::move(fresh);
    endComparison(session);
    session.state.selectedLight = 0;
    session.state.soloLight = -1;
    session.state.probe.term.clear();
    resetView(session);
}

void saveScene(Session& session, std::string path)
{
    if (session.state.putAside)
        return tell(session, session.state.putAside->title +
                                 " is on screen and is not saved. Esc brings your scene back; save it then.");
    if (path.empty())
        path = session.sceneFile;
    if (path.empty())
        path = freeName(picturesFolder(), session.state.scene.mesh->name, session.state.scene.surface.model, ".json");
    if (const Result<void> saved = reflectance::saveScene(session.state.scene, path); !saved)
        return complain(session, saved.error());
    session.sceneFile = path;
    session.autosave.settle(session.state.scene);
    tell(session, "Scene saved: " + path);
}

void saveView(Session& session, const std::string& path)
{
    const Result<std::string> saved =
        saveViewPicture(session.state, session.viewport, session.renderer, session.second, path);
    if (saved)
        tell(session, "Picture saved: " + *saved);
    else
        complain(session, saved.error());
}

/// "curves.svg" becomes mug_curves_001.svg or the like; empty where it could not be written.
std::string saveText(Session& session, const fs::path& name, const std::string& text)
{
    const fs::path path =
        freeName(picturesFolder(), session.state.scene.mesh->name, name.stem().string(), name.extension().string());
    if (const Result<void> saved = writeAtomically(path.string(), text); !saved) {
        complain(session, saved.error());
        return {};
    }
    tell(session, "Saved: " + path.string());
    return path.string();
}

void openText(Session& session, const Request& request)
{
    if (std::string path = saveText(session, request.path, request.text); !path.empty())
        session.toOpen.push_back(std::move(path));
}

void fitText(Session& session, const Request& request)
{
    std::string path = saveText(session, request.path, request.text);
    if (path.empty())
        return;
    FitWish& wish = session.state.fit.wish;
    wish.file = std::move(path);
    wish.surface = 1;
    wish.model = "oren_nayar";
    session.state.fit.asked = true;
    session.state.preferences.workbenchPage = "fit";
}

/// A stroke that is under way would write over what comes back.
void travel(Session& session, const Request& request)
{
    if (session.viewport.dragging())
        return;
    ExplorerState& state = session.state;
    if (request.kind == Request::Kind::Undo)
        state.history.undo(state);
    else if (request.kind == Request::Kind::Redo)
        state.history.redo(state);
    else
        state.history.go(std::stoul(request.path), state);
}

void cancelLoading(Session& session)
{
    session.loader.cancel();
    session.toOpen.clear();
}

void showTour(Session& session, const Request& request)
{
    showTourStep(session.state, request.path.empty() ? session.state.preferences.tourStep : std::stoi(request.path));
    // Once the card stands beside the picture, which is narrower then.
    session.state.requests.push_back({Request::Kind::Frame, {}});
}

void serve(Session& session, const Request& request)
{
    using Kind = Request::Kind;
    switch (request.kind) {
    case Kind::OpenFile:
        return session.toOpen.push_back(request.path);
    case Kind::OpenDialog:
        return void(session.state.showFileBrowser = true);
    case Kind::SaveView:
        return saveView(session, request.path);
    case Kind::SaveWindow:
        return void(session.windowPicture = request.path);
    case Kind::SaveScene:
        return saveScene(session, request.path);
    case Kind::Frame:
        return frame(session);
    case Kind::ResetView:
        return resetView(session);
    case Kind::ResetScene:
        return resetScene(session);
    case Kind::SaveText:
        return void(saveText(session, request.path, request.text));
    case Kind::SaveRegion:
        return void(session.region = regionFrom(request.path, request.text));
    case Kind::OpenText:
        return openText(session, request);
    case Kind::FitText:
        return fitText(session, request);
    case Kind::CancelLoading:
        return cancelLoading(session);
    case Kind::LeaveCase:
        return void(leaveCase(session.state));
    case Kind::TogglePage:
        return togglePage(session.state, std::stoi(request.path));
    case Kind::Undo:
    case Kind::Redo:
    case Kind::GoToStep:
        return travel(session, request);
    case Kind::ShowTour:
        return showTour(session, request);
    case Kind::Quit:
        return void(session.quit = true);
    case Kind::Dismiss:
        return session.autosave.dismiss(request.path);
    }
}

/// The two variants as a picture showed them.
void showAs(CompareView& compare, const PictureRecipe& recipe)
{
    compare.divider = static_cast<float>(recipe.divider);
    compare.on = compare.on && recipe.shown != VariantView::A;
    compare.handOnB = compare.on && recipe.shown == VariantView::B;
    compare.mode = recipe.shown == VariantView::Wipe         ? CompareMode::Wipe
                   : recipe.shown == VariantView::Difference ? CompareMode::Difference
                   : recipe.shown == VariantView::B          ? CompareMode::Flip
                                                             : CompareMode::SideBySide;
}

struct TakeOver {
    Session& session;
    const std::string& path;

    void operator()(std::shared_ptr<const Mesh> mesh) const
    {
        Scene& scene = session.state.scene;
        const bool another = scene.meshFile != path;
        scene.mesh = std::move(mesh);
        scene.meshFile = path;
        if (another)
            frame(session);
    }
    void operator()(Scene scene) const
    {
        session.state.scene = std::move(scene);
        endComparison(session);
        session.state.compare.on = session.state.scene.other.has_value();
        session.state.selectedLight = session.state.scene.lights.empty() ? -1 : 0;
        session.state.soloLight = -1;
        session.state.probe.term.clear();
        session.state.panels.matrices.clear(); // what a narrower mode hid belongs to the scene before
        session.sceneFile = path;
    }
    /// The picture itself stays as it is: Ctrl+S finds the scene a file of its own.
    void operator()(KeptPicture kept) const
    {
        const std::string written = kept.program;
        const std::string none;
        TakeOver{session, none}(std::move(kept.scene));
        showAs(session.state.compare, kept.recipe);
        session.state.probe.term = kept.recipe.term;
        tell(session, "The session of this picture is restored, as version " + written + " saved it.");
    }
    void operator()(std::shared_ptr<const MeasuredTable> table) const
    {
        Surface& surface = session.state.scene.surface;
        surface.model = "table";
        surface.tableFile = path;
        surface.table = std::move(table);
    }
    void operator()(std::shared_ptr<const Model> model) const
    {
        if (const auto complaint = compiled(session.renderer, *model); !complaint)
            return complain(session, complaint.error());
        useModel(surfaceInHand(session.state.compare, session.state.scene), std::move(model), path);
        session.ownModels.watch(path);
        tell(session, "The model is in use. Saving its file brings it here anew.");
    }
    void operator()(Environment environment) const
    {
        session.state.scene.environment = std::move(environment);
        if (!modelOf(session.state.scene).text.usesEnvironment)
            tell(session, "The environment is loaded; only models that reflect it, such as the mirror, show it.");
    }
};

/// An earlier session stays where it is until it is on screen. It has no scene file: Ctrl+S finds it a new one.
void restore(Session& session, LoadedFile file)
{
    if (!file.content)
        return complain(session, file.content.error());
    Scene restored = std::get<Scene>(std::move(file.content).value());
    session.autosave.adopt(file.path, session.state.scene, restored);
    const std::string none;
    TakeOver{session, none}(std::move(restored));
    tell(session, "The session is restored. Ctrl+S saves it to a file of its own.");
}

void takeOver(Session& session, LoadedFile file)
{
    leaveCase(session.state); // what is opened meets the user's scene
    if (session.autosave.offers(file.path))
        return restore(session, std::move(file));
    if (!file.content)
        return complain(session, file.content.error());
    session.state.message.reset();
    std::visit(TakeOver{session, file.path}, std::move(file.content).value());
    std::error_code ignored;
    if (fs::is_regular_file(file.path, ignored))
        remember(session.state.preferences, fs::absolute(file.path, ignored).lexically_normal().string());
}

/// The watched file was saved: its new version, or what is wrong with it while the last good one stays.
void renewOwnModel(Session& session)
{
    const std::optional<Result<std::shared_ptr<const Model>>> saved = session.ownModels.saved(Clock::now());
    if (!saved)
        return;
    if (!*saved)
        return complain(session, saved->error());
    if (const auto complaint = compiled(session.renderer, ***saved); !complaint)
        return complain(session, complaint.error());
    if (!renewIn(session.state.scene, **saved, session.ownModels.path()))
        return session.ownModels.forget();
    tell(session, "The model was read anew: " + session.ownModels.path());
}

} // namespace

void serveRequests(Session& session)
{
    for (const Request& request : std::exchange(session.state.requests, {}))
        serve(session, request);
}

void pollFiles(Session& session)
{
    if (std::optional<LoadedFile> file = session.loader.take())
        takeOver(session, std::move(*file));
    if (!session.loader.progress() && !session.toOpen.empty()) {
        session.loader.start(session.toOpen.front(), session.state.scene.recomputeNormals);
        session.toOpen.pop_front();
    }
    session.state.loading = session.loader.progress();
    renewOwnModel(session);
}

} // namespace reflectance::explorer
