#include "app/explorer/ui/workbench/colour_page.h"

#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/savable_plot.h"
#include "app/explorer/ui/widgets.h"
#include "app/explorer/ui/workbench/colour_views.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

constexpr float controlsWidth = 236.0F;

struct Named {
    const char* id;
    const char* name;
    const char* about;
};

constexpr Named sensors[] = {
    {"gaussian", "Gaussian filters", "Three filters whose overlap the slider sets: the lecture's argument."},
    {"nikon_d5100", "Nikon D5100", "A camera with filters over its pixels, as measured."},
    {"cie_1931", "CIE 1931 observer", "X, Y, Z of the standard observer."},
    {"srgb", "Linear sRGB", "What linear sRGB would see; negative in places."},
    {"narrow", "Bands of 10 nm", "Filters so narrow that a diagonal K is nearly right."}};

constexpr Named primaries[] = {{"E", "Equal energy, three bands", "Red, green and blue parts of a flat spectrum."},
                               {"display", "Display", "Gaussian primaries of a display."},
                               {"leds", "Coloured LEDs", "Three narrow Gaussian primaries."},
                               {"D65", "D65, three bands", "Daylight, divided at 490 and 580 nm."},
                               {"FL11", "FL11, three bands", "A fluorescent lamp, divided at 490 and 580 nm."}};

constexpr Named lights[] = {{"white", "White of the primaries", "All primaries at strength 1."},
                            {"warm", "Warm", "Primaries at 1, 0.75, 0.5."},
                            {"cool", "Cool", "Primaries at 0.6, 0.8, 1."},
                            {"saturated red", "Saturated red", "Primaries at 1, 0.2, 0.2."},
                            {"saturated green", "Saturated green", "Primaries at 0.2, 1, 0.2."},
                            {"saturated blue", "Saturated blue", "Primaries at 0.2, 0.2, 1."},
                            {"pure red", "Pure red", "The red primary alone."},
                            {"pure green", "Pure green", "The green primary alone."},
                            {"pure blue", "Pure blue", "The blue primary alone."},
                            {"D65", "Lamp D65", "A spectrum that the primaries may not make: no K is exact."},
                            {"A", "Lamp A", "Incandescent: no K is exact."},
                            {"FL2", "Lamp FL2", "Fluorescent: no K is exact."},
                            {"FL11", "Lamp FL11", "Three narrow bands: no K is exact."},
                            {"LED3", "Lamp of three LEDs", "Three narrow bands: no K is exact."}};

template <std::size_t count>
void menu(const char* id, const char* about, const Named (&entries)[count], std::string& chosen)
{
    const auto current =
        std::find_if(std::begin(entries), std::end(entries), [&](const Named& e) { return chosen == e.id; });
    ImGui::SetNextItemWidth(-1);
    if (!beginMenu(id, current == std::end(entries) ? chosen.c_str() : current->name)) {
        tooltip(about);
        return;
    }
    for (const Named& entry : entries) {
        if (ImGui::Selectable(entry.name, chosen == entry.id))
            chosen = entry.id;
        tooltip(entry.about);
    }
    ImGui::EndCombo();
}

void crossingRow(ColourPage& page, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "crossing";
    row.label = "Overlap";
    row.about = "The height at which neighbouring filters cross. At 0 they do not overlap and K is diagonal.";
    row.sliderMax = 0.9;
    row.legalMin = 0.0;
    row.legalMax = 0.95;
    row.initial = 0.3;
    numberRow(row, page.question.crossing, message);
}

void cheatRow(ColourPage& page)
{
    static constexpr Choice cheats[] = {
        {"full", "The full K: exact for every light that the primaries can make."},
        {"best", "The diagonal closest to K over nine lights, least squares."},
        {"diag M", "diag(M) I: the lecture's cheat, with the light in primary strengths."},
        {"drop", "K in the sensor convention with its off-diagonals dropped."},
        {"white", "The colour under white taken for the albedo, as renderers do."}};
    ImGui::PushID("cheat");
    const int pressed = choiceRow(cheats, static_cast<int>(page.cheat));
    if (pressed >= 0)
        page.cheat = static_cast<Cheat>(pressed);
    ImGui::PopID();
}

void conventionRow(ColourPage& page)
{
    static constexpr Choice conventions[] = {
        {"primary",
         "Lights are strengths of the primaries: K = M. Off-diagonals come from overlap alone, even for grey."},
        {"sensor",
         "Lights are what the sensor sees of them on white: K = M W\u207B\u00B9. A grey surface is diagonal."}};
    ImGui::PushID("convention");
    const int pressed = choiceRow(conventions, static_cast<int>(page.convention));
    if (pressed >= 0)
        page.convention = static_cast<Convention>(pressed);
    ImGui::PopID();
}

void useButton(ExplorerState& state, const ColorAnswer& answer)
{
    const ColourPage& page = state.colour;
    const bool pressed = ImGui::Button("Use this K", {-1, 0});
    tooltip("Gives the scene's surface this K, in the convention chosen.");
    if (!pressed)
        return;
    Surface& surface = state.scene.surface;
    if (modelOf(state.scene).text.find("K") == nullptr)
        surface.model = "lambert_color";
    const JudgedSurface& patch = answer.patches[page.patch];
    const auto K = rowByRow(page.convention == Convention::Primary ? patch.M : patch.K);
    surface.values["K"] = {K.begin(), K.end()};
    surface.convention = page.convention;
    surface.W = page.convention == Convention::Primary ? rowByRow(answer.system.W) : Surface().W;
}

/// Prices the cheats on the user's object; what was found stands below.
void objectButton(ColourPage& page)
{
    ObjectStudy& study = page.object;
    if (study.running) {
        remark("shading wavelength by wavelength, " + std::to_string(static_cast<int>(100.0 * study.done)) + " %");
    } else {
        study.asked |= ImGui::Button("Price on the object", {-1, 0});
        tooltip("Every cheat on the object in the picture, with this patch's reflectance, against the spectral "
                "integral: under the "
                "scene's lights as strengths of the primaries, or under the lamp chosen.");
    }
    if (!study.found)
        return;
    if (!study.found->problem.empty())
        return remark(study.found->problem, palette::error);
    const PicturePrice& price = study.found->prices[static_cast<std::size_t>(page.cheat)];
    remark(study.found->surface + ", " + study.found->light + ": dE2000 " + general(price.mean, 2) + " mean, " +
               general(price.p95, 2) + " p95, " + general(price.max, 2) + " max",
           price.max > 2.3 ? palette::warning : palette::text);
    tooltip("Of the cheat chosen above, over the pixels that the object covers whole.");
}

void chartOrPairRow(ColourPage& page)
{
    static constexpr Choice views[] = {
        {"chart", "The 24 patches: above the spectral truth, below the cheat."},
        {"metamers",
         "The patch and a twin with the same K, under the primaries' white and under the light chosen: where three "
         "numbers for the light fail, no K can tell them apart."}};
    ImGui::PushID("views");
    const int pressed = choiceRow(views, page.showsPair ? 1 : 0);
    if (pressed >= 0)
        page.showsPair = pressed == 1;
    ImGui::PopID();
}

/// Derives K again where the question has changed.
void deriveAgain(ColourPage& page)
{
    if (page.asked == page.question)
        return;
    page.asked = page.question;
    auto found = answered(page.question);
    page.problem = found ? "" : found.error().message;
    if (found)
        page.answer = *std::move(found);
}

} // namespace

void drawColourPage(ExplorerState& state)
{
    ColourPage& page = state.colour;
    ImGui::BeginChild("controls", {points(controlsWidth), 0}, false, ImGuiWindowFlags_NavFlattened);
    menu("##sensor", "The sensor's three filters.", sensors, page.question.sensor);
    if (page.question.sensor == "gaussian")
        crossingRow(page, state.message);
    menu("##primaries", "The light's three primaries.", primaries, page.question.primaries);
    menu("##under", "The light on the chart.", lights, page.question.under);
    conventionRow(page);
    cheatRow(page);
    chartOrPairRow(page);
    deriveAgain(page);
    if (page.answer) {
        useButton(state, *page.answer);
        objectButton(page);
    }
    if (!page.problem.empty())
        remark(page.problem, palette::error);
    ImGui::EndChild();
    if (!page.answer)
        return;

    ImGui::SameLine();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float matrixWidth = points(168);
    const bool plotFits = room.x > points(470);
    const float chartWidth = plotFits ? std::min(1.2F * room.y, 0.34F * room.x) : room.x - matrixWidth - points(10);
    if (plotFits) {
        const float plotWidth = room.x - chartWidth - matrixWidth - points(20);
        savablePlot("spectra", spectraChart(*page.answer, page.patch), {plotWidth, room.y}, state);
        ImGui::SameLine();
    }
    drawDerivedMatrix(page, {matrixWidth, room.y});
    if (chartWidth < points(60))
        return;
    ImGui::SameLine();
    if (page.showsPair)
        drawPair(page, {chartWidth, room.y});
    else
        drawPatches(page, {chartWidth, room.y});
}

} // namespace reflectance::explorer
