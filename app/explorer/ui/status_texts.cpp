#include "app/explorer/ui/status_texts.h"

#include "app/explorer/ui/numerals.h"
#include "core/base/text.h"
#include "core/scene/requirements.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

std::string inThousands(std::size_t count)
{
    const auto n = static_cast<double>(count);
    return count < 1000      ? std::to_string(count)
           : count < 1000000 ? general(n / 1e3, 3) + "k"
                             : general(n / 1e6, 3) + "M";
}

StatusPart framePart(const ExplorerState& state)
{
    const std::string time = duration(state.frameMilliseconds);
    return {time + " per frame", time, "Time to draw the last frame. A window at rest draws nothing.", 8, false};
}

StatusPart trianglePart(const ExplorerState& state)
{
    const std::size_t count = state.scene.mesh ? state.scene.mesh->triangles.size() : 0;
    const std::size_t vertices = state.scene.mesh ? state.scene.mesh->positions.size() : 0;
    const StandInFacts& standIn = state.standIn;
    std::string about = grouped(count) + " triangles, " + grouped(vertices) + " vertices.";
    if (standIn.triangles > 0)
        about += "\nWhile the camera moves, a stand-in of " + grouped(standIn.triangles) + " triangles is drawn (" +
                 general(static_cast<double>(standIn.bytes) / 1e6, 2) +
                 " MB), since whole pictures are slow here; at rest every triangle is there.";
    if (standIn.shown)
        return {"moving: " + grouped(standIn.triangles) + " of " + grouped(count) + " triangles",
                inThousands(standIn.triangles) + " of " + inThousands(count), about, 5, true};
    return {grouped(count) + " triangles", inThousands(count) + " tri", about, 5, false};
}

StatusPart rendererPart(const ExplorerState& state)
{
    return {state.renderer, std::string(trimmed(state.renderer.substr(0, state.renderer.find('(')))),
            "Drawn by OpenGL on " + state.renderer + ".", 1, false};
}

/// The tag that was measured against the general path; null where none was.
const PriceTag* comparedWithGeneral(const std::vector<PriceTag>& tags)
{
    const auto found =
        std::find_if(tags.begin(), tags.end(), [](const PriceTag& tag) { return tag.generalMilliseconds > 0.0; });
    return found == tags.end() ? nullptr : &*found;
}

StatusPart leftOutPart(const std::vector<std::string>& sentences, const PriceTag* tag)
{
    const std::string count = std::to_string(sentences.size()) + " left out";
    std::string full = sentences.size() == 1 ? "left out: " + sentences[0] : count;
    std::string about = "Only what the scene requires is computed. Left out:\n\u2022 " + joined(sentences, "\n\u2022 ");
    if (tag) {
        const double saved = tag->generalMilliseconds - tag->milliseconds;
        const std::string share = general(100.0 * saved / tag->generalMilliseconds, 2) + " %";
        // Less than nothing is the clock's noise.
        full += saved > 0.0 ? ", saves " + share : "";
        about += "\nShading with everything, in " + tag->name + ": " + duration(tag->generalMilliseconds) +
                 "; without: " + duration(tag->milliseconds) + (saved > 0.0 ? ", " + share + " less." : ", no less.");
    }
    return {full, count, about, 6, true};
}

StatusPart pricePart(const PriceTag& tag)
{
    const std::string time = tag.name + " " + duration(tag.milliseconds);
    const bool isTruth = tag.name == "double";
    const std::string error = isTruth ? ", exact" : ", error " + written(tag.maxError, 2);
    std::string about = tag.name + ": shading the whole picture once takes " + duration(tag.milliseconds) + ".\n";
    if (isTruth)
        about += "This is the truth that the others are measured against.";
    else
        about += "Largest difference of a linear channel to the double picture: " + written(tag.maxError, 3) +
                 "; RMSE " + written(tag.rmse, 3) + ".";
    if (tag.worstX >= 0)
        about += "\nWorst at pixel (" + std::to_string(tag.worstX) + ", " + std::to_string(tag.worstY) + ").";
    return {time + error, time, about, isTruth ? 2 : 4, false};
}

/// Linear values beside the code values.
StatusPart pixelPart(const PixelReading& pixel)
{
    const auto code = [](double value) { return std::to_string(quantised(value)); };
    const std::string codes = code(pixel.code.x) + " " + code(pixel.code.y) + " " + code(pixel.code.z);
    const std::string place = "(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
    const auto linear = [&](int digits) {
        return general(pixel.linear.x, digits) + " " + general(pixel.linear.y, digits) + " " +
               general(pixel.linear.z, digits);
    };
    return {place + "  " + linear(3) + "  \u2192 " + codes, linear(2) + " \u2192 " + codes,
            "Pixel " + place + ": linear red, green and blue before the sensor, " + linear(6) +
                ", and the 8-bit codes after it, " + codes + ".",
            7, false};
}

} // namespace

std::vector<StatusPart> pictureParts(const ExplorerState& state)
{
    std::vector<StatusPart> parts{framePart(state), trianglePart(state)};
    if (!state.renderer.empty())
        parts.push_back(rendererPart(state));
    if (state.pixel)
        parts.push_back(pixelPart(*state.pixel));
    return parts;
}

std::vector<StatusPart> priceParts(const ExplorerState& state)
{
    std::vector<StatusPart> parts;
    if (const std::vector<std::string> sentences = leftOut(shownScene(state)); !sentences.empty())
        parts.push_back(leftOutPart(sentences, comparedWithGeneral(state.priceTags)));
    for (const PriceTag& tag : state.priceTags)
        parts.push_back(pricePart(tag));
    if (state.measuringPrices && state.priceTags.empty())
        parts.push_back({"measuring float, SIMD and GL against double\u2026", "measuring\u2026",
                         "The price tags of this scene are being measured.", 3, false});
    return parts;
}

std::vector<PartForm> formsThatFit(std::span<const PartWidth> parts, float available)
{
    std::vector<PartForm> forms(parts.size(), PartForm::Full);
    float total = 0.0F;
    for (const PartWidth& part : parts)
        total += part.full;
    std::vector<std::size_t> order(parts.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return parts[a].weight < parts[b].weight; });
    for (const std::size_t i : order) {
        if (total <= available)
            return forms;
        forms[i] = PartForm::Brief;
        total -= parts[i].full - parts[i].brief;
    }
    for (const std::size_t i : order) {
        if (total <= available)
            return forms;
        forms[i] = PartForm::Gone;
        total -= parts[i].brief;
    }
    return forms;
}

} // namespace reflectance::explorer
