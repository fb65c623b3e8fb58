#include "app/explorer/ui/workbench/probe_views.h"

#include "app/explorer/ui/formula_view.h"
#include "app/explorer/ui/numerals.h"
#include "app/explorer/ui/widgets.h"
#include "core/base/text.h"

#include <algorithm>

namespace reflectance::explorer {
namespace {

/// As the filled-in statements have; what is copied has all of them.
constexpr int digits = 4;
constexpr float nameWidth = 54.0F, widestColumn = 80.0F;

std::vector<std::string> numbersOf(const Vec3d& v, int places = digits)
{
    return {general(v.x, places), general(v.y, places), general(v.z, places)};
}

/// Small text that breaks at blanks alone: ImGui would break a number behind its point.
void lines(const std::string& text, ImU32 color)
{
    const float room = ImGui::GetContentRegionAvail().x;
    std::string line;
    const auto flush = [&] {
        ImGui::PushFont(face(Face::Small));
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(line.c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
    };
    for (const std::string_view word : words(text)) {
        const std::string longer = line.empty() ? std::string(word) : line + " " + std::string(word);
        if (!line.empty() && sizeIn(Face::Small, longer).x > room) {
            flush();
            line = word;
        } else {
            line = longer;
        }
    }
    flush();
}

/// "N.L   0.7071"; numbers stand in columns, below one another where the row is too narrow for them.
void row(const char* name, const std::vector<std::string>& values, const char* about, ImU32 color = palette::text)
{
    const float start = ImGui::GetCursorPosX();
    const float room = ImGui::GetContentRegionAvail().x - points(nameWidth);
    float widest = 0.0F;
    for (const std::string& value : values)
        widest = std::max(widest, sizeIn(Face::Small, value).x + points(8));
    const auto columns = std::clamp<std::size_t>(static_cast<std::size_t>(room / std::max(widest, 1.0F)), 1, 3);
    ImGui::BeginGroup();
    remark(name);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto column = static_cast<float>(i % columns);
        if (i == 0 || i % columns != 0)
            ImGui::SameLine();
        ImGui::SetCursorPosX(start + points(nameWidth) +
                             column * std::max(widest, std::min(room / 3.0F, points(widestColumn))));
        if (values.size() == 1)
            lines(values[i], color);
        else
            remark(values[i], color);
    }
    ImGui::EndGroup();
    tooltip(about);
}

void row(const char* name, const std::string& value, const char* about, ImU32 color = palette::text)
{
    row(name, std::vector<std::string>{value}, about, color);
}

std::string numbersText(const std::vector<double>& numbers)
{
    std::vector<std::string> parts;
    for (const double number : numbers)
        parts.push_back(general(number, digits));
    return joined(parts, " ");
}

void heading(const char* title)
{
    remark(title, palette::accent, Face::Strong);
}

/// True where it was pressed: a light's name, chosen while its formula is filled in.
bool lightHeading(const ProbedLight& light, bool chosen)
{
    const std::string name = std::to_string(light.index + 1) + "  " + light.name;
    ImGui::PushFont(face(Face::Body));
    const std::string shown = elided(name, ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x);
    ImGui::PopFont();
    const bool pressed = toggleButton((shown + "##" + std::to_string(light.index)).c_str(), chosen);
    tooltip("Fill the formula in with this light.");
    return pressed;
}

void accountLine(const walked::AccountLine& line)
{
    ImGui::BeginGroup();
    lines(line.name + " = " + line.expression, palette::quiet);
    ImGui::EndGroup();
    tooltip("A statement of the model's text, line " + std::to_string(line.line) +
            "; below it with its numbers filled in, and its value in double.");
    ImGui::Indent(points(12));
    if (line.filled != line.expression)
        lines("= " + line.filled, palette::text);
    lines("= " + numbersText(line.numbers), palette::text);
    for (const std::string& note : line.notes)
        lines(note, palette::good);
    ImGui::Unindent(points(12));
}

const ProbedLight* shownLight(const ProbeStudy& study, const Probe& probe)
{
    return probe.lights.empty() ? nullptr : &probe.lights[std::min(study.light, probe.lights.size() - 1)];
}

} // namespace

void drawProbedLights(ProbeStudy& study, const Probe& probe)
{
    heading("Light");
    row("P", numbersOf(probe.point.P), "The point, in the scene's units: the object's bounding sphere has radius 1.");
    row("N", numbersOf(probe.point.N), "The shading normal there, of length 1.");
    row("V", numbersOf(probe.V), "The direction to the eye, of length 1.");
    row("N.V", general(probe.NV, 6), "The cosine of the angle between N and V.");
    if (probe.lights.empty())
        remark("No light shines.", palette::warning);
    const ProbedLight* shown = shownLight(study, probe);
    for (std::size_t i = 0; i < probe.lights.size(); ++i) {
        const ProbedLight& light = probe.lights[i];
        ImGui::PushID(static_cast<int>(i));
        if (lightHeading(light, shown == &light))
            study.light = i;
        if (light.kind == LightKind::Point) {
            row("sent", numbersOf(light.sent), "The light's intensity, before distance.");
            row("distance", general(light.distance, digits),
                "From the point to the light, scene units; I is what was sent over its square.");
        }
        row("I", numbersOf(light.I),
            "Red, green and blue as they arrive here, as the sensor sees them on a perfect white.");
        row("L", numbersOf(light.L), "The direction to the light, of length 1.");
        row("R", numbersOf(light.R), "L mirrored about N: R = 2N(N.L) - L.");
        row("N.L", general(light.cosine, 6), "The cosine of the angle of incidence; not above 0, the light is behind.");
        row("R.V", general(light.mirrorCosine, 6),
            "The cosine between the mirrored light and the eye: 1 is a highlight's "
            "middle.");
        ImGui::PopID();
    }
}

void drawProbedSurface(ProbeStudy& study, const Probe& probe)
{
    heading("Surface");
    drawFormula(typeset(probe.formula), ImGui::GetContentRegionAvail().x);
    if (!probe.convention.empty())
        remark(probe.convention);
    if (const ProbedLight* light = shownLight(study, probe)) {
        for (const walked::AccountLine& line : light->account.lines)
            accountLine(line);
        for (const ProbedTerm& term : light->terms) {
            row(term.name.c_str(), numbersOf(term.value), "What this term of the formula gives by itself.");
            ImGui::Indent(points(12));
            lines(term.source, palette::quiet);
            ImGui::Unindent(points(12));
        }
    }
    ImGui::Separator();
    for (const ProbedLight& light : probe.lights)
        row(light.name.c_str(), numbersOf(light.value), "What this light adds: red, green, blue.");
    if (probe.surroundings)
        row("around", numbersOf(*probe.surroundings), "What the surface shows of its surroundings.");
    row("sum", numbersOf(probe.value),
        "Linear red, green and blue before the sensor, in double: the renderer's value.");
}

void drawProbedSensor(const Probe& probe, const std::optional<ProbedPixel>& pixel, const std::string& name)
{
    heading(name.empty() ? "Sensor" : ("Sensor, " + name).c_str());
    row("linear", numbersOf(probe.value), "The sum over the lights, in double.");
    row("gain", general(probe.gain, digits),
        "Exposure and camera together: 2^EV where the sensor is as it is at first.");
    row("exposed", numbersOf(probe.exposed), "Linear times gain.");
    static constexpr const char* channels[] = {"red", "green", "blue"};
    std::vector<std::string> clipped;
    for (std::size_t i = 0; i < 3; ++i)
        if (probe.clipped[i])
            clipped.emplace_back(channels[i]);
    row("clipped", clipped.empty() ? "nothing" : joined(clipped), "Channels below 0 or above 1 after exposure.",
        clipped.empty() ? palette::text : palette::warning);
    row("encoded", numbersOf(probe.encoded), "After the sensor's other parts and its encoding, 0 .. 1.");
    row("code", {std::to_string(probe.codes[0]), std::to_string(probe.codes[1]), std::to_string(probe.codes[2])},
        "What the window shows, 0 .. 255.");
    if (!pixel)
        return row("GL drew", "\u2026", "Once the picture rests, GL's pixel is held against double.", palette::quiet);
    if (!pixel->seen)
        return row("GL drew", "another point: this one is hidden", "The object, or its edge, lies before the point.",
                   palette::warning);
    if (!pixel->drawn)
        return row("GL drew", "an edge", "The object covers only a part of this pixel: it is no value of this point.",
                   palette::quiet);
    const GlPixel& gl = *pixel->drawn;
    const auto drew = numbersOf(gl.drawn, 7);
    const auto exact = numbersOf(gl.exact, 7);
    row("", std::vector<std::string>{"GL drew", "double"},
        "The pixel in which the point lies: the mean of its samples, in this driver's float; and the same samples in "
        "double. Where a pixel has several, this is not yet the point's value.",
        palette::quiet);
    for (std::size_t i = 0; i < 3; ++i)
        row(channels[i], std::vector<std::string>{drew[i], exact[i]},
            "Digit under digit: where the driver's float leaves double.");
    row("apart", written(gl.difference, 3) + ", bound " + written(gl.bound, 3),
        "The largest difference of a channel in terms of its bound, 64 (kappa + 1) 2^-23 of the value.",
        gl.ratio <= 1.0 ? palette::good : palette::error);
}

} // namespace reflectance::explorer
