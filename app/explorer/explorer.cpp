#include "app/explorer/explorer.h"

#include "app/explorer/differences.h"
#include "app/explorer/fits.h"
#include "app/explorer/frame_pace.h"
#include "app/explorer/lab_runs.h"
#include "app/explorer/pictures.h"
#include "app/explorer/plot_polls.h"
#include "app/explorer/preferences.h"
#include "app/explorer/prices.h"
#include "app/explorer/probe_view.h"
#include "app/explorer/requests.h"
#include "app/explorer/sensor_polls.h"
#include "app/explorer/session.h"
#include "app/explorer/study_renderer.h"
#include "app/explorer/thumbnails.h"
#include "app/explorer/trades.h"
#include "app/explorer/trust_view.h"
#include "app/explorer/ui/guide_card.h"
#include "app/explorer/ui/ui.h"
#include "app/explorer/user_folders.h"

#include <imgui.h>
#include <iostream>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reflectance::explorer {
namespace {

/// Files that are read faster than this are there with the first picture.
constexpr std::chrono::milliseconds patienceAtStart{300};
/// The turntable's turn, radians per second: once round in a quarter of a minute.
constexpr double turntableSpeed = 0.42;

constexpr ImGuiWindowFlags fixedWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// An ImGui window that fills an area of the layout.
void beginArea(const char* name, const Area& area, ImGuiWindowFlags more, bool padded)
{
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({std::max(1.0F, area.width), std::max(1.0F, area.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize,
                        {1.0F, 1.0F}); // bars are thinner than windows may be by themselves
    if (!padded)
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin(name, nullptr, fixedWindow | more);
    ImGui::PopStyleVar(padded ? 3 : 4);
}

/// A bar that the mouse takes hold of, with a line along its middle. True while it is held.
bool drawBar(const char* name, const Area& area, ImGuiMouseCursor cursor, float scale)
{
    beginArea(name, area, ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav, false);
    ImGui::InvisibleButton("##grip", {std::max(1.0F, area.width), std::max(1.0F, area.height)});
    const bool held = ImGui::IsItemActive();
    const bool touched = ImGui::IsItemHovered() || held;
    if (touched)
        ImGui::SetMouseCursor(cursor);
    const ImU32 color = ImGui::GetColorU32(touched ? ImGuiCol_SeparatorHovered : ImGuiCol_Separator);
    const float thickness = touched ? 2.0F * scale : 1.0F;
    const ImVec2 middle{std::round(area.x + 0.5F * area.width), std::round(area.y + 0.5F * area.height)};
    if (area.height > area.width)
        ImGui::GetWindowDrawList()->AddLine({middle.x, area.y}, {middle.x, area.bottom()}, color, thickness);
    else
        ImGui::GetWindowDrawList()->AddLine({area.x, middle.y}, {area.right(), middle.y}, color, thickness);
    ImGui::End();
    return held;
}

void drawSplitter(ExplorerState& state, const Area& area, float windowWidth, float scale)
{
    if (!drawBar("##splitter", area, ImGuiMouseCursor_ResizeEW, scale))
        return;
    const float wanted = (windowWidth - ImGui::GetIO().MousePos.x - 0.5F * area.width) / scale;
    state.preferences.panelWidth = allowedPanelWidth(wanted, windowWidth, scale);
}

/// The workbench below the picture, the grip that sizes it, and its tabs.
void drawBench(ExplorerState& state, const Layout& layout, float scale)
{
    beginArea("##tabs", layout.tabs, ImGuiWindowFlags_NoScrollWithMouse, false);
    drawWorkbenchTabs(state);
    ImGui::End();
    if (layout.workbench.height <= 0.0F)
        return;
    if (drawBar("##bench grip", layout.grip, ImGuiMouseCursor_ResizeNS, scale)) {
        const float room = layout.workbench.bottom() - layout.picture.y - layout.tabs.height;
        const float wanted = layout.workbench.bottom() - ImGui::GetIO().MousePos.y - 0.5F * layout.grip.height;
        state.preferences.workbenchHeight = allowedWorkbenchHeight(wanted / scale, room, scale);
    }
    beginArea("##workbench", layout.workbench, ImGuiWindowFlags_None, true);
    drawWorkbench(state);
    ImGui::End();
}

/// The picture, and beside it the tour's card.
void drawView(Session& session, Area picture, float scale)
{
    ExplorerState& state = session.state;
    if (state.guide.number > 0) {
        beginArea("##guide", takeGuideColumn(picture, scale), ImGuiWindowFlags_None, true);
        drawGuideCard(state);
        ImGui::End();
    }
    beginArea("##view", picture, ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav, false);
    drawViewport(state, session.viewport, session.renderer, session.second, session.standIn, picture,
                 session.window.pixelsPerPoint(), scale);
    drawProbes(session, picture);
    drawTrust(session, picture);
    ImGui::End();
}

void drawInterface(Session& session)
{
    ExplorerState& state = session.state;
    const float scale = session.window.scale();
    const ViewSize size = session.window.size();
    const auto width = static_cast<float>(size.width);
    const Wishes wishes{state.preferences.panelWidth,
                        workbenchIsOpen(state) ? state.preferences.workbenchHeight : 0.0F};
    const Layout layout = layoutOf(width, static_cast<float>(size.height),
                                   {toolbarHeight(), statusLineHeight(), workbenchTabsHeight()}, wishes, scale);
    beginArea("##toolbar", layout.toolbar, ImGuiWindowFlags_NoScrollWithMouse, true);
    drawToolbar(state);
    ImGui::End();
    beginArea("##panels", layout.panels, ImGuiWindowFlags_AlwaysVerticalScrollbar, true);
    drawPanels(state);
    ImGui::End();
    drawSplitter(state, layout.splitter, width, scale);
    drawView(session, layout.picture, scale);
    drawBench(state, layout, scale);
    beginArea("##status", layout.status, ImGuiWindowFlags_NoScrollWithMouse, true);
    drawStatusLine(state);
    ImGui::End();
    drawHelp(state);
    drawFileBrowser(state);
}

void tryNextHazard(Session& session)
{
    if (session.state.extremes.running)
        session.state.extremes.step(
            programInstruments(studyRenderer(session), "the window's driver gave no second renderer"));
}

void turnTable(Session& session, double seconds)
{
    if (session.state.turntable && !session.viewport.dragging())
        session.state.scene.camera = orbited(session.state.scene.camera, turntableSpeed * std::min(seconds, 0.1), 0.0);
}

void saveAskedWindowPicture(Session& session)
{
    const std::optional<std::string> path = std::exchange(session.windowPicture, std::nullopt);
    if (!path)
        return;
    const Result<std::string> saved =
        saveWindowPicture(session.state, session.viewport, session.window.framebuffer(), Window::loader(), *path);
    session.state.message = saved ? Message{"Window saved: " + *saved, false} : Message{saved.error().sentence(), true};
}

void saveAskedRegion(Session& session)
{
    const std::optional<WindowRegion> region = std::exchange(session.region, std::nullopt);
    if (!region)
        return;
    const ViewSize framebuffer = session.window.framebuffer();
    const float scale = static_cast<float>(framebuffer.width) / static_cast<float>(session.window.size().width);
    const Result<std::string> saved = saveRegionPicture(session.state, *region, framebuffer, scale, Window::loader());
    session.state.message = saved ? Message{"Saved: " + *saved, false} : Message{saved.error().sentence(), true};
}

void keepSession(Session& session)
{
    session.autosave.watch(usersScene(session.state), Clock::now());
    session.state.earlierSessions = session.autosave.earlier();
    if (const std::optional<Error> problem = session.autosave.takeProblem())
        session.state.message = Message{"The session is not kept against a crash: " + problem->sentence(), true};
}

/// A hand is on something, or what it asked for is not done: the change is not whole yet.
bool isBusy(const Session& session)
{
    return session.viewport.dragging() || ImGui::IsAnyItemActive() || !session.state.requests.empty();
}

void noteHistory(Session& session)
{
    ExplorerState& state = session.state;
    const bool busy = isBusy(session);
    state.history.watch(state, {busy, state.turntable, state.loading.has_value()}, Clock::now());
}

void titleWindow(Session& session)
{
    const Scene& scene = session.state.scene;
    session.window.setTitle(scene.mesh->name + " - " + modelOf(scene).text.name + " - Reflectance Explorer");
}

void noteFirstPicture(Session& session)
{
    session.start.note("shown");
    if (!session.state.firstPicture.empty())
        return;
    session.state.firstPicture = session.start.sentence();
    if (!session.quitsAfterFirst)
        return;
    std::cout << session.start.report();
    session.quit = true;
}

void drawOnce(Session& session)
{
    const Events events = session.window.takeEvents();
    for (const KeyPress& key : events.keys)
        press(key, session.state);
    serveProbeKey(session);
    playTape(session);
    session.window.giveArrowsToPicture(session.state.grab.on && !session.state.showFileBrowser);
    session.toOpen.insert(session.toOpen.end(), events.dropped.begin(), events.dropped.end());
    session.state.drawSoon = false;
    session.window.beginFrame();
    session.start.note("fonts");
    session.state.takingPicture = session.region.has_value();
    if (session.state.takingPicture) // no reading beside the mouse in the picture of a plot
        ImGui::GetIO().MousePos = {-FLT_MAX, -FLT_MAX};
    drawInterface(session);
    session.start.note("the scene's picture, panels");
    session.window.drawFrame();
    saveAskedWindowPicture(session);
    saveAskedRegion(session);
    session.window.showFrame();
    noteFirstPicture(session);
    pollPrices(session);
    pollTrade(session);
    pollDifference(session);
    pollThumbnails(session);
    pollPlots(session);
    serveRequests(session);
    pollFiles(session);
    tryNextHazard(session);
    pollFit(session);
    pollSensorStudy(session);
    pollLab(session);
    pollTableFacts(session.state.tablePage, session.tableFacts, session.tableAsked);
    recordTape(session, events.keys, isBusy(session) || session.state.loading.has_value());
    noteHistory(session);
    keepSession(session);
    titleWindow(session);
}

Reasons reasonsOf(const Session& session)
{
    const auto untilRefined = session.viewport.cameraMoved + restBeforeRefining(session.viewport) - Clock::now();
    const bool refine = session.viewport.refinementOwed && !session.viewport.dragging();
    return {
        .animating = session.state.turntable || session.windowPicture.has_value() || session.region.has_value() ||
                     session.state.extremes.running || !session.tape.toPlay.empty() ||
                     (session.state.trade.running && !session.trades.steps.busy()),
        .loading = session.state.loading.has_value() || !session.toOpen.empty() || session.state.fit.running ||
                   session.state.colour.object.running || session.state.lab.running,
        .drawSoon = session.state.drawSoon,
        .untilRefined =
            refine ? std::chrono::duration<double>(untilRefined).count() : std::numeric_limits<double>::infinity(),
        .untilPrices =
            std::min({secondsUntilPrices(session), secondsUntilDifference(session),
                      session.ownModels.watches() ? std::chrono::duration<double>(OwnModelWatch::pause).count()
                                                  : std::numeric_limits<double>::infinity()}),
        .untilAutosave = session.autosave.secondsUntilWrite(Clock::now()),
    };
}

void runLoop(Session& session)
{
    FramePace pace;
    Clock::time_point last = Clock::now();
    while (!session.quit && !session.window.closing()) {
        const double seconds = pace.secondsToWait(reasonsOf(session));
        const Clock::time_point asleep = Clock::now();
        const bool happened = session.window.wait(seconds);
        const Clock::time_point now = Clock::now();
        if (!happened && std::chrono::duration<double>(now - asleep).count() < seconds)
            continue; // woken for nothing
        pace.waited(happened);
        turnTable(session, std::chrono::duration<double>(now - last).count());
        last = now;
        drawOnce(session);
    }
}

void openAtStart(Session& session, const ExplorerOptions& options)
{
    if (!options.input.empty())
        session.toOpen.push_back(options.input);
    if (!options.modelFile.empty())
        session.toOpen.push_back(options.modelFile);
    if (options.environment)
        session.toOpen.push_back(*options.environment);
    pollFiles(session);
    session.loader.waitFor(patienceAtStart);
    pollFiles(session);
}

void keepPreferences(Session& session)
{
    const ViewSize size = session.window.size();
    Preferences& preferences = session.state.preferences;
    preferences.windowWidth = static_cast<int>(std::lround(static_cast<float>(size.width) / session.window.scale()));
    preferences.windowHeight = static_cast<int>(std::lround(static_cast<float>(size.height) / session.window.scale()));
    // Nobody is left to read a message; losing the window's size is no harm.
    if (!savePreferences(preferences, settingsFolder()))
        return;
}

} // namespace

Result<Outcome> runExplorer(const ExplorerOptions& options)
{
    StartClock clock;
    clock.note("program loaded, options read");
    std::optional<Recording> recording;
    if (!options.replay.empty()) {
        Result<Recording> loaded = loadRecording(options.replay);
        if (!loaded)
            return loaded.error();
        recording = *std::move(loaded);
    }
    const std::optional<Desktop> desktop = Desktop::connect();
    if (!desktop)
        return Outcome::NoDisplay;
    clock.note("display");
    const Result<Preferences> preferences = loadPreferences(settingsFolder());
    const Preferences start = preferences ? *preferences : Preferences();
    Result<Window> window = Window::open(start.windowWidth, start.windowHeight, start.interfaceScale);
    if (!window)
        return window.error();
    clock.note("window and GL context");
    Result<GlRenderer> renderer = GlRenderer::create(Window::loader(), programsFolder());
    if (!renderer)
        return renderer.error();

    clock.note("renderer");
    Session session(*window, *renderer);
    session.start = clock;
    session.state.preferences = start;
    session.state.renderer = renderer->description();
    session.state.scene = defaultScene();
    session.state.scene.camera = framedWithHandles(session.state.scene.camera, session.viewport.view.size);
    if (!preferences)
        session.state.message = Message{preferences.error().sentence(), true};
    openAtStart(session, options);
    session.autosave.settle(session.state.scene);
    session.start.note("scene");
    if (recording)
        loadTape(session, *recording);
    noteHistory(session);
    if (!options.record.empty())
        startRecording(session, options.record);
    if (options.tour > 0)
        session.state.requests.push_back({Request::Kind::ShowTour, std::to_string(options.tour)});
    session.quitsAfterFirst = options.firstPicture;
    runLoop(session);
    session.autosave.end();
    keepPreferences(session);
    return Outcome::Closed;
}

} // namespace reflectance::explorer
