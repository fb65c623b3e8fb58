#include "app/explorer/viewport.h"

#include "app/explorer/ui/compare_overlay.h"
#include "app/explorer/viewed_scene.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace reflectance::explorer {
namespace {

/// A drag that only shades shows every sample as long as a picture takes no longer than this.
constexpr double smoothMilliseconds = 40.0;
/// Points that a hand may move between press and release and still have clicked.
constexpr float clickReach = 3.0F;

Modifiers modifiers()
{
    return {.shift = ImGui::GetIO().KeyShift, .control = ImGui::GetIO().KeyCtrl};
}

ImGuiMouseButton imguiButton(MouseButton button)
{
    return button == MouseButton::Left    ? ImGuiMouseButton_Left
           : button == MouseButton::Right ? ImGuiMouseButton_Right
                                          : ImGuiMouseButton_Middle;
}

/// What the tool Grab holds from here on. False where there is nothing to take.
bool beginGrab(ExplorerState& state, Viewport& viewport, Cursor cursor)
{
    const std::optional<Grasp> grasp = state.grab.hovered;
    if (!grasp || viewport.hoveredLight >= 0 || modifiers().shift || modifiers().control ||
        !ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        return false;
    viewport.button = MouseButton::Left;
    viewport.pressed = {MouseButton::Left, {}, viewport.view.size, -1, state.selectedLight, cursor, cursor, grasp};
    viewport.stroke = grabStroke(*grasp, cursor, viewport.view.size, state.compare, state.scene);
    state.selectedLight = viewport.stroke.light;
    return true;
}

/// Follows the cursor as far as it is on the object; a recording ends where the hand was last of use.
void continueGrab(ExplorerState& state, Viewport& viewport, Cursor cursor)
{
    const Result<void> followed = follow(viewport.stroke, viewport.view.size, cursor, state.compare, state.scene);
    state.grab.problem = followed ? std::string() : followed.error().sentence();
    if (followed)
        viewport.pressed.to = cursor;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return;
    const bool click = cursor.x == viewport.stroke.start.x && cursor.y == viewport.stroke.start.y;
    viewport.stroke = {};
    state.grab.problem.clear();
    if (click) {
        probeUnder(state, viewport.pressed.from, viewport.view.size);
        viewport.done.emplace_back(RecordedProbe{viewport.pressed.from, viewport.view.size});
        return;
    }
    viewport.done.emplace_back(viewport.pressed);
}

void beginStroke(ExplorerState& state, Viewport& viewport, Cursor cursor)
{
    if (beginGrab(state, viewport, cursor))
        return;
    for (const MouseButton button : {MouseButton::Left, MouseButton::Right, MouseButton::Middle}) {
        if (!ImGui::IsMouseClicked(imguiButton(button)))
            continue;
        viewport.button = button;
        viewport.strayed = false;
        viewport.pressed = {button, modifiers(), viewport.view.size, viewport.hoveredLight, state.selectedLight,
                            cursor, cursor};
        viewport.stroke = strokeFrom(button, modifiers(), cursor, viewport.hoveredLight, state.selectedLight,
                                     state.scene.lights, state.scene.camera, viewport.view.size);
        if (viewport.stroke.light >= 0)
            state.selectedLight = viewport.stroke.light;
        return;
    }
}

/// A click turns nothing: the object stays until the hand has left the place where it pressed.
bool isClick(Viewport& viewport, Cursor cursor)
{
    if (viewport.stroke.kind != Stroke::Kind::Orbit)
        return false;
    const double way = std::hypot(cursor.x - viewport.stroke.start.x, cursor.y - viewport.stroke.start.y);
    viewport.strayed =
        viewport.strayed || way > static_cast<double>(clickReach * viewport.view.pixelsPerPoint * viewport.view.scale);
    return !viewport.strayed;
}

void continueStroke(ExplorerState& state, Viewport& viewport, Cursor cursor)
{
    Stroke& stroke = viewport.stroke;
    if (stroke.kind == Stroke::Kind::Grab)
        return continueGrab(state, viewport, cursor);
    const bool lightGone = stroke.movesLight() && stroke.light >= static_cast<int>(state.scene.lights.size());
    const bool click = isClick(viewport, cursor);
    if (stroke.movesCamera())
        state.scene.camera = click ? stroke.cameraBefore : cameraOf(stroke, viewport.view.size, cursor);
    else if (!lightGone)
        state.scene.lights[static_cast<std::size_t>(stroke.light)] = lightOf(stroke, viewport.view.size, cursor);
    // The frame that sees the release still follows the hand: a quick stroke may fit between two frames.
    if (!lightGone && ImGui::IsMouseDown(imguiButton(viewport.button)))
        return;
    stroke = {};
    if (click) {
        probeUnder(state, viewport.pressed.from, viewport.view.size);
        viewport.done.emplace_back(RecordedProbe{viewport.pressed.from, viewport.view.size});
        return;
    }
    viewport.pressed.to = cursor;
    viewport.done.emplace_back(viewport.pressed);
}

/// Ctrl+drag while comparing marks the rectangle that the figures are taken of, Ctrl+click the whole object again. True
/// while the mouse is at it.
bool drawRegion(CompareView& compare, const PictureView& view, Cursor cursor, bool hovered)
{
    const Cursor share{std::clamp(cursor.x / view.size.width, 0.0, 1.0),
                       std::clamp(cursor.y / view.size.height, 0.0, 1.0)};
    const bool starts = compare.on && hovered && modifiers().control && !modifiers().shift &&
                        ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (starts) {
        compare.drawsRegion = true;
        compare.regionStart = {share.x, share.y, share.x, share.y};
        compare.region.reset();
    }
    if (!compare.drawsRegion)
        return false;
    const Region& start = compare.regionStart;
    const Region drawn{std::min(start.left, share.x), std::min(start.top, share.y), std::max(start.left, share.x),
                       std::max(start.top, share.y)};
    constexpr double smallest = 0.01; // less was a click
    if (drawn.right - drawn.left > smallest && drawn.bottom - drawn.top > smallest)
        compare.region = drawn;
    compare.drawsRegion = compare.on && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    return true;
}

void lookForGrip(ExplorerState& state, const Viewport& viewport, Cursor cursor)
{
    GrabTool& tool = state.grab;
    if (tool.on && viewport.hoveredLight < 0)
        tool.hovered = graspUnder(cursor, 0.6 * handleReach(viewport.view), tool.view, state.compare, state.scene,
                                  state.selectedLight, tool.overObject);
}

/// One frame of the mouse over the picture.
void handleMouse(ExplorerState& state, Viewport& viewport)
{
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Cursor cursor = viewport.view.cursorAt(mouse.x, mouse.y);
    const bool hovered = ImGui::IsItemHovered();
    viewport.hovered = hovered;
    if (viewport.dragging()) {
        continueStroke(state, viewport, cursor);
        return;
    }
    viewport.hoveredLight = -1;
    state.grab.hovered.reset();
    if (drawRegion(state.compare, viewport.view, cursor, hovered) || !hovered)
        return;
    if (state.preferences.showLightHandles)
        viewport.hoveredLight =
            handleAt(state.scene.lights, state.scene.camera, viewport.view.size, cursor, handleReach(viewport.view));
    lookForGrip(state, viewport, cursor);
    if (const auto steps = static_cast<double>(ImGui::GetIO().MouseWheel); steps != 0.0) {
        state.scene.camera = zoomedByWheel(state.scene.camera, steps);
        viewport.done.emplace_back(RecordedWheel{steps});
    }
    if (viewport.hoveredLight >= 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        Light& light = state.scene.lights[static_cast<std::size_t>(viewport.hoveredLight)];
        light.on = !light.on;
    } else {
        beginStroke(state, viewport, cursor);
    }
}

RenderSettings settingsFor(const ExplorerState& state, Viewport& viewport)
{
    const Clock::time_point now = Clock::now();
    if (state.scene.camera != viewport.shownCamera) {
        viewport.shownCamera = state.scene.camera;
        viewport.cameraMoved = now;
    }
    const bool moving =
        state.turntable || viewport.stroke.movesCamera() || now - viewport.cameraMoved < restBeforeRefining(viewport);
    const bool shading = viewport.stroke.movesLight() || (ImGui::IsAnyItemActive() && !state.compare.holdsDivider);
    viewport.cameraMoves = moving;
    const bool coarse = moving || (shading && viewport.fullMilliseconds > smoothMilliseconds);
    viewport.refinementOwed = coarse && state.preferences.samplesPerAxis > 1;
    return {viewport.view.size.width, viewport.view.size.height, coarse ? 1 : state.preferences.samplesPerAxis};
}

std::uint64_t picturesOf(const GlRenderer& renderer, const SecondView& second)
{
    return renderer.work().shadings + renderer.work().developments + second.pictures();
}

void render(ExplorerState& state, Viewport& viewport, GlRenderer& renderer, SecondView& second, StandIn& standIn)
{
    viewport.settings = settingsFor(state, viewport);
    Scene shown = viewedScene(state);
    shown.mesh = standIn.meshFor(shown.mesh, viewport.cameraMoves, viewport.fullMilliseconds);
    state.standIn = standIn.facts();
    viewport.refinementOwed = viewport.refinementOwed || state.standIn.shown;
    const std::uint64_t before = picturesOf(renderer, second);
    const Clock::time_point start = Clock::now();
    Result<void> rendered = renderer.render(shown, viewport.settings);
    if (rendered)
        rendered = second.render(shown, state.compare.on, viewport.settings, renderer);
    state.idleRungsA = second.rungsA.withoutEffect();
    state.idleRungsB = second.rungsB.withoutEffect();
    if (!rendered) {
        state.message = Message{rendered.error().sentence(), true};
        return;
    }
    if (picturesOf(renderer, second) == before)
        return;
    renderer.finish();
    state.frameMilliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (viewport.settings.samplesPerAxis == state.preferences.samplesPerAxis && !state.standIn.shown)
        viewport.fullMilliseconds = state.frameMilliseconds;
    ++viewport.pictures;
}

/// A bar in the middle of the lower edge, with what is being read and a way to stop it.
void drawLoading(ExplorerState& state, const Area& area, float scale)
{
    if (!state.loading)
        return;
    const float width = std::min(320.0F * scale, 0.8F * area.width);
    ImGui::SetCursorScreenPos({area.x + 0.5F * (area.width - width), area.bottom() - 84.0F * scale});
    ImGui::BeginChild("##loading", {width, 64.0F * scale}, true, ImGuiWindowFlags_NoScrollbar);
    const std::string name = state.loading->file.substr(state.loading->file.find_last_of('/') + 1);
    ImGui::TextUnformatted(("Opening " + name).c_str());
    const float button = 72.0F * scale;
    ImGui::ProgressBar(static_cast<float>(state.loading->done),
                       {ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x, 0.0F});
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {button, 0.0F}))
        state.requests.push_back({Request::Kind::CancelLoading, {}});
    ImGui::EndChild();
}

/// The part of a picture of `whole` that lies in `part`.
void drawTexture(ImDrawList& canvas, unsigned texture, const Area& whole, const Area& part, bool rowsFromTop)
{
    const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
    // Row 0 of a picture that GL drew is its lowest.
    const float top = rowsFromTop ? 0.0F : 1.0F;
    canvas.PushClipRect({part.x, part.y}, {part.right(), part.bottom()}, true);
    canvas.AddImage(id, {whole.x, whole.y}, {whole.right(), whole.bottom()}, {0.0F, top}, {1.0F, 1.0F - top});
    canvas.PopClipRect();
}

/// What lies over A's picture, where A is seen.
void drawOverlay(ImDrawList& canvas, const CompareView& compare, unsigned overlay, const Panes& panes)
{
    const bool showsA = !compare.on || compare.mode == CompareMode::SideBySide || compare.mode == CompareMode::Wipe ||
                        (compare.mode == CompareMode::Flip && !compare.handOnB);
    if (overlay == 0 || !showsA)
        return;
    Area part = panes.a;
    if (compare.on && compare.mode == CompareMode::Wipe)
        part.width *= compare.divider;
    drawTexture(canvas, overlay, panes.a, part, true);
}

void drawPictures(ImDrawList& canvas, const ExplorerState& state, const GlRenderer& renderer, const SecondView& second,
                  const Area& area, const Panes& panes)
{
    const CompareView& compare = state.compare;
    const auto draw = [&](ShownTexture picture, const Area& whole, const Area& part) {
        drawTexture(canvas, picture.id, whole, part, picture.rowsFromTop);
    };
    const ShownTexture a = second.shownA(state.scene, renderer);
    const ShownTexture b = compare.on ? second.shownB(state.scene, renderer) : a;
    if (compare.on && compare.mode == CompareMode::Difference && second.map.id() != 0)
        return drawTexture(canvas, second.map.id(), area, area, true);
    if (compare.on && compare.mode == CompareMode::Flip)
        return draw(compare.handOnB ? b : a, area, area);
    draw(a, panes.a, panes.a);
    if (!compare.on)
        return;
    Area part = panes.b;
    if (compare.mode == CompareMode::Wipe) {
        part.x = area.x + compare.divider * area.width;
        part.width = area.right() - part.x;
    }
    draw(b, panes.b, part);
}

/// The handles in every pane, for the hand may take one in either.
void drawHandles(ImDrawList& canvas, const ExplorerState& state, const Viewport& viewport, const Panes& panes, int held)
{
    for (const Area* pane : {&panes.a, &panes.b}) {
        PictureView view = viewport.view;
        view.x = pane->x;
        canvas.PushClipRect({pane->x, pane->y}, {pane->right(), pane->bottom()}, true);
        drawLightHandles(canvas, state, view, viewport.hoveredLight, held);
        canvas.PopClipRect();
        if (panes.a.x == panes.b.x)
            return;
    }
}

/// What the tool Grab holds or would take, beside the mouse.
void showGrip(const ExplorerState& state, const Viewport& viewport)
{
    const GrabTool& tool = state.grab;
    if (viewport.stroke.kind == Stroke::Kind::Grab) {
        const Grasp held{viewport.stroke.taken, static_cast<std::size_t>(viewport.stroke.light), 0.0};
        ImGui::SetTooltip("%s",
                          (tool.problem.empty() ? nameOf(held, state.compare, state.scene) : tool.problem).c_str());
    } else if (tool.on && tool.hovered && !viewport.dragging()) {
        const bool far = std::isinf(tool.hovered->pixels);
        const std::string name = nameOf(*tool.hovered, state.compare, state.scene);
        const char* effect = far                                ? "drag, and it comes here"
                             : tool.hovered->grip == Grip::Edge ? "drag it to change how wide it is"
                                                                : "drag it, and the light follows";
        ImGui::SetTooltip("%s: %s", name.c_str(), effect);
    }
}

void setCursorShape(const ExplorerState& state, const Viewport& viewport)
{
    const bool grabs = viewport.stroke.kind == Stroke::Kind::Grab;
    const std::optional<Grip> grip = grabs                ? std::optional(viewport.stroke.taken)
                                     : state.grab.hovered ? std::optional(state.grab.hovered->grip)
                                                          : std::nullopt;
    if (grip && !viewport.stroke.movesCamera())
        ImGui::SetMouseCursor(*grip == Grip::Spot   ? ImGuiMouseCursor_Hand
                              : *grip == Grip::Edge ? ImGuiMouseCursor_ResizeNESW
                                                    : ImGuiMouseCursor_ResizeAll);
    else if (viewport.stroke.movesLight() || viewport.hoveredLight >= 0)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    else if (viewport.stroke.kind == Stroke::Kind::Pan)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

} // namespace

Clock::duration restBeforeRefining(const Viewport& viewport)
{
    const std::chrono::duration<double, std::milli> rest(std::clamp(2.0 * viewport.fullMilliseconds, 150.0, 2000.0));
    return std::chrono::duration_cast<Clock::duration>(rest);
}

void drawViewport(ExplorerState& state, Viewport& viewport, GlRenderer& renderer, SecondView& second, StandIn& standIn,
                  const Area& area, float pixelsPerPoint, float scale)
{
    const auto pixels = [pixelsPerPoint](float points) {
        return std::max(1, static_cast<int>(std::lround(points * pixelsPerPoint)));
    };
    const Panes panes = panesOf(state.compare, area, scale);
    const bool onB = viewport.dragging() ? viewport.view.x == panes.b.x : ImGui::GetIO().MousePos.x >= panes.b.x;
    viewport.view = {
        onB ? panes.b.x : panes.a.x, area.y, {pixels(panes.a.width), pixels(area.height)}, pixelsPerPoint, scale};
    state.grab.view = viewport.view.size;
    ImGui::SetCursorScreenPos({area.x, area.y});
    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton("##picture", {std::max(1.0F, area.width), std::max(1.0F, area.height)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    handleMouse(state, viewport);
    render(state, viewport, renderer, second, standIn);

    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    drawPictures(canvas, state, renderer, second, area, panes);
    drawOverlay(canvas, state.compare, viewport.overlay, panes);
    const bool grabs = viewport.stroke.kind == Stroke::Kind::Grab;
    const int held = viewport.stroke.movesLight() ? viewport.stroke.light : -1;
    if (state.preferences.showLightHandles || held >= 0)
        drawHandles(canvas, state, viewport, panes, held);
    const int told = held >= 0 ? held : viewport.hoveredLight;
    showGrip(state, viewport);
    if (!grabs && told >= 0 && told < static_cast<int>(state.scene.lights.size()))
        showLightTooltip(state, told);
    setCursorShape(state, viewport);
    drawCompareOverlay(state, area, panes);
    drawLoading(state, area, scale);
}

} // namespace reflectance::explorer
