#include "app/explorer/ui/sensor_parts.h"

#include "app/explorer/ui/number_row.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"
#include "core/sensor/fields.h"

#include <array>
#include <cmath>

namespace reflectance::explorer {

namespace {

struct Range {
    double low, high; ///< of the slider
    double legalLow, legalHigh;
    double initial;
    bool logarithmic = false;
};

void number(ExplorerState& state, const char* label, const char* unit, const char* about, Range range, double& value)
{
    NumberRow row;
    row.name = row.label = label;
    row.unit = unit;
    row.about = about;
    row.sliderMin = range.low;
    row.sliderMax = range.high;
    row.logarithmic = range.logarithmic;
    row.legalMin = range.legalLow;
    row.legalMax = range.legalHigh;
    row.initial = range.initial;
    numberRow(row, value, state.message);
}

void whole(ExplorerState& state, const char* label, const char* unit, const char* about, Range range, int& value)
{
    double shown = value;
    number(state, label, unit, about, range, shown);
    value = static_cast<int>(std::lround(shown));
}

void drawCamera(ExplorerState& state)
{
    CameraExposure& camera = state.scene.sensor.camera;
    number(state, "Aperture", "", "f-number N: light falls with its square.", {1.0, 32.0, 0.5, 128.0, 16.0, true},
           camera.aperture);
    number(state, "Shutter", "s", "Exposure time t, seconds.", {1e-4, 10.0, 1e-6, 3600.0, 0.01, true}, camera.shutter);
    number(state, "ISO", "", "Speed S. Noise is that of 100 / S of the electrons.",
           {50.0, 25600.0, 1.0, 1e7, 100.0, true}, camera.iso);
    number(state, "White is", "cd/m\u00B2", "Luminance of radiance 1: a white diffuser that faces a light of 1.",
           {1.0, 1e5, 1e-6, 1e9, 30720.0, true}, camera.white);
}

void drawVignetting(ExplorerState& state)
{
    static constexpr std::array<Choice, 2> kinds = {{
        {"cos\u2074", "The fourth power of the cosine of the angle to the axis."},
        {"polynomial", "1 + a r\u00B2 + b r\u2074 + c r\u2076, r = 1 in the corners; never below 0."},
    }};
    Vignetting& vignetting = state.scene.sensor.vignetting;
    if (const int pressed = choiceRow(kinds, static_cast<int>(vignetting.kind)); pressed >= 0)
        vignetting.kind = static_cast<FallOff>(pressed);
    if (vignetting.kind == FallOff::Cos4)
        return number(state, "Corner angle", "\u00B0", "Between the axis and the picture's corners.",
                      {0.0, 60.0, 0.0, 80.0, 25.0}, vignetting.corner);
    const Range range{-1.0, 1.0, -1e6, 1e6, 0.0};
    number(state, "a", "", "Factor of r\u00B2.", range, vignetting.polynomial.x);
    number(state, "b", "", "Factor of r\u2074.", range, vignetting.polynomial.y);
    number(state, "c", "", "Factor of r\u2076.", range, vignetting.polynomial.z);
}

void drawNoise(ExplorerState& state)
{
    Noise& noise = state.scene.sensor.noise;
    ImGui::Checkbox("shot noise", &noise.shot);
    tooltip("Light comes in photons: the variance is the number of electrons.");
    number(state, "Read noise", "e\u207B", "Standard deviation of reading a pixel, in electrons.",
           {0.0, 100.0, 0.0, 1e6, 5.0}, noise.read);
    number(state, "Full well", "e\u207B", "Electrons at value 1 (times 100 / ISO with the camera on).",
           {100.0, 1e5, 1.0, 1e9, 20000.0, true}, noise.fullWell);
    whole(state, "Seed", "", "The same seed gives the same noise, in the window as in files; of the dither, too.",
          {0.0, 100.0, 0.0, 1e9, 1.0}, noise.seed);
}

void drawWell(ExplorerState& state)
{
    number(state, "Limit", "", "A pixel holds no more than this. 1 is white.", {0.1, 10.0, 1e-6, 1e6, 1.0, true},
           state.scene.sensor.well.limit);
}

void drawBalance(ExplorerState& state)
{
    Balance& balance = state.scene.sensor.balance;
    const Range range{0.0, 4.0, 0.0, 1e6, 1.0};
    number(state, "Red gain", "", "White balance of the red channel.", range, balance.gains.x);
    number(state, "Green gain", "", "White balance of the green channel.", range, balance.gains.y);
    number(state, "Blue gain", "", "White balance of the blue channel.", range, balance.gains.z);
    const float gap = points(4);
    const float cell = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (std::size_t i = 0; i < 9; ++i) {
        NumberRow row;
        row.name = "colour matrix " + std::to_string(i);
        row.label = "Colour matrix, row " + std::to_string(i / 3 + 1) + ", column " + std::to_string(i % 3 + 1);
        row.about = "What the balanced channel of this column adds to the channel of this row.";
        row.sliderMin = -2.0;
        row.sliderMax = 2.0;
        row.initial = i % 4 == 0 ? 1.0 : 0.0;
        numberField(row, balance.matrix[i], cell, state.message);
        if (i % 3 < 2)
            ImGui::SameLine(0, gap);
    }
}

void drawCurveFile(ExplorerState& state)
{
    Response& response = state.scene.sensor.response;
    std::array<char, 1024> typed{};
    response.file.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##curve", "path of a CSV file", typed.data(), typed.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue))
        if (const auto read = readCurveOf(response, typed.data()); !read)
            state.message = Message{read.error().sentence(), true};
    tooltip("A measured curve: light, response (or light, red, green, blue) on every line. Enter reads it.");
    if (!response.curve)
        remark("Without a file it is linear.", palette::warning);
}

void drawResponse(ExplorerState& state)
{
    static constexpr std::array<Choice, 2> kinds = {{
        {"gamma", "The power 1/gamma of the light."},
        {"measured", "A curve from a CSV file."},
    }};
    Response& response = state.scene.sensor.response;
    if (const int pressed = choiceRow(kinds, static_cast<int>(response.kind)); pressed >= 0)
        response.kind = static_cast<ResponseKind>(pressed);
    if (response.kind == ResponseKind::Curve)
        return drawCurveFile(state);
    number(state, "Gamma", "", "Light to the power of 1/gamma, before the encoding.", {0.5, 4.0, 0.1, 10.0, 2.2},
           response.gamma);
}

void drawEncoding(ExplorerState& state)
{
    static constexpr std::array<Choice, 3> kinds = {{
        {"linear", "Codes in proportion to light. The window shows them as if they were sRGB, so it looks dark."},
        {"sRGB", "The exact curve of IEC 61966-2-1."},
        {"Rec. 709", "The camera's curve of ITU-R BT.709."},
    }};
    Encoding& encoding = state.scene.sensor.encoding;
    if (const int pressed = choiceRow(kinds, static_cast<int>(encoding.kind)); pressed >= 0)
        encoding.kind = static_cast<EncodingKind>(pressed);
}

void drawQuantisation(ExplorerState& state)
{
    Quantisation& quantisation = state.scene.sensor.quantisation;
    whole(state, "Bits", "", "2^bits levels. A PNG has 16 bits where these are more than 8; the window shows 8.",
          {1.0, 16.0, 1.0, 16.0, 8.0}, quantisation.bits);
    ImGui::Checkbox("dither", &quantisation.dither);
    tooltip("Rounds up as often as the fraction says: noise instead of bands, and the mean is kept.");
}

struct PartEntry {
    const char* name;
    const char* about;
    const char* id; ///< in files and flags
    bool& (*on)(Sensor&);
    void (*draw)(ExplorerState&);
};

/// At the row's right end: nothing else than this part, as for lights.
void soloButton(ExplorerState& state, const PartEntry& part)
{
    const float width = points(48);
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
    const bool alone = state.soloPart == part.id;
    if (toggleButton("alone", alone, {width, 0}))
        state.soloPart = alone ? "" : part.id;
    tooltip(alone ? "Show the whole chain again." : "Show this part alone, beside exposure and encoding.");
}

void drawNothing(ExplorerState&) {}

constexpr PartEntry parts[] = {
    {"Exposure", "The EV above; off, radiance arrives as it is.", "exposure",
     [](Sensor& s) -> bool& { return s.exposes; }, drawNothing},
    {"Camera", "Shutter, aperture and ISO: the gain is white t S / (120 N\u00B2), 1 at f/16, 1/100 s, ISO 100.",
     "camera", [](Sensor& s) -> bool& { return s.camera.on; }, drawCamera},
    {"Vignetting", "Light lost towards the corners.", "vignetting", [](Sensor& s) -> bool& { return s.vignetting.on; },
     drawVignetting},
    {"Noise", "Shot and read noise, the same for the same seed.", "noise",
     [](Sensor& s) -> bool& { return s.noise.on; }, drawNoise},
    {"Full well", "A pixel that is full stays full.", "well", [](Sensor& s) -> bool& { return s.well.on; }, drawWell},
    {"White balance, matrix", "Gains of the channels, then a colour matrix.", "balance",
     [](Sensor& s) -> bool& { return s.balance.on; }, drawBalance},
    {"Response", "What the camera makes of light before it encodes it; off, it is linear.", "response",
     [](Sensor& s) -> bool& { return s.response.on; }, drawResponse},
    {"Encoding", "From linear values to codes; off, they stay linear.", "encoding",
     [](Sensor& s) -> bool& { return s.encoding.on; }, drawEncoding},
    {"Quantisation", "Rounding to whole codes; off, only the file's 16 bits round.", "quantisation",
     [](Sensor& s) -> bool& { return s.quantisation.on; }, drawQuantisation},
};

} // namespace

void drawSensorParts(ExplorerState& state)
{
    for (const PartEntry& part : parts) {
        bool& on = part.on(state.scene.sensor);
        ImGui::PushID(part.name);
        ImGui::Checkbox(part.name, &on);
        tooltip(part.about);
        if (!on && state.soloPart == part.id)
            state.soloPart.clear();
        if (on) {
            if (part.draw != drawNothing)
                soloButton(state, part);
            ImGui::Indent(points(12));
            part.draw(state);
            ImGui::Unindent(points(12));
        }
        ImGui::PopID();
    }
}

std::string sensorPartsSummary(const Sensor& sensor)
{
    std::vector<std::string> words;
    const auto say = [&words](bool differs, std::string word) {
        if (differs)
            words.push_back(std::move(word));
    };
    say(!sensor.exposes, "not exposed");
    say(sensor.camera.on, "camera");
    say(sensor.vignetting.on, "vignetting");
    say(sensor.noise.on, "noise");
    say(sensor.well != Well(), "well");
    say(sensor.balance.on, "balance");
    say(sensor.response.on, "response");
    const EncodingKind kind = sensor.encoding.on ? sensor.encoding.kind : EncodingKind::Linear;
    say(kind != EncodingKind::Srgb, kind == EncodingKind::Linear ? "linear" : "Rec. 709");
    say(sensor.quantisation != Quantisation(),
        sensor.quantisation.on ? std::to_string(sensor.quantisation.bits) + " bit" : "not quantised");
    return joined(words);
}

} // namespace reflectance::explorer
