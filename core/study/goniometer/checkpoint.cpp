#include "core/study/goniometer/checkpoint.h"

#include "core/base/number_list.h"
#include "core/base/text.h"
#include "core/measured/lines.h"

#include <algorithm>
#include <charconv>

namespace reflectance {
namespace {

constexpr std::string_view firstLine = "reflectance goniometer 1";

void appendNumbers(std::string& text, std::string_view name, std::span<const double> numbers)
{
    text.append(name);
    for (const double number : numbers)
        text.append(" ").append(shortest(number));
    text += '\n';
}

std::optional<std::uint64_t> wholeNumber(std::string_view text)
{
    std::uint64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

    Result<LabRun> read()
    {
        const auto first = lines_.next();
        if (!first || *first != firstLine)
            return wrong("is no goniometer run of this version; its first line must be \"" + std::string(firstLine) +
                         "\"");
        for (std::string_view name :
             {"surface", "fingerprint", "model", "values", "channels", "bounces", "masking", "shadowing", "azimuth",
              "seed", "theta_i", "theta_r", "delta_phi", "lost", "cells"})
            if (auto taken = takeFact(name); !taken)
                return taken.error();
        for (LabCell& cell : run_.cells)
            if (auto taken = takeCell(cell); !taken)
                return taken.error();
        if (lines_.next())
            return wrong("goes on after its last cell");
        return std::move(run_);
    }

private:
    [[nodiscard]] Error wrong(std::string what) const { return {std::move(what), file_, lines_.number()}; }

    Result<void> takeFact(std::string_view name)
    {
        const auto line = lines_.next();
        if (!line || line->substr(0, line->find(' ')) != name)
            return wrong("a line that begins with \"" + std::string(name) + "\" is missing here");
        const std::string_view rest = trimmed(line->substr(std::min(line->size(), name.size())));
        return keep(name, rest) ? Result<void>()
                                : wrong("\"" + std::string(name) + "\" cannot be " + quotedPiece(rest));
    }

    bool keep(std::string_view name, std::string_view text)
    {
        LabSetup& setup = run_.setup;
        if (name == "surface" || name == "model") {
            (name == "surface" ? setup.surface : setup.model) = text;
            return !text.empty();
        }
        if (name == "azimuth" && text == "mixed")
            return true;
        if (name == "values" || name == "azimuth" || name.find('_') != std::string_view::npos)
            return keepNumbers(name, text);
        const auto number = wholeNumber(text);
        return number && keepCount(name, *number);
    }

    bool keepNumbers(std::string_view name, std::string_view text)
    {
        auto numbers = numbersInWords(text);
        if (!numbers)
            return false;
        LabSetup& setup = run_.setup;
        if (name == "values")
            setup.values = *std::move(numbers);
        else if (name == "azimuth" && numbers->size() == 1)
            setup.azimuth = numbers->front();
        else if (name == "azimuth")
            return false;
        else
            setup.shape.axes.push_back(*std::move(numbers));
        return true;
    }

    bool keepCount(std::string_view name, std::uint64_t number)
    {
        LabSetup& setup = run_.setup;
        if (name == "fingerprint")
            run_.fingerprint = number;
        else if (name == "seed")
            setup.seed = number;
        else if (name == "lost")
            run_.lost = number;
        else if (name == "channels")
            setup.channels = number;
        else if (name == "bounces" && number <= static_cast<std::uint64_t>(mostBounces))
            setup.effects.bounces = static_cast<int>(number);
        else if ((name == "masking" || name == "shadowing") && number <= 1)
            (name == "masking" ? setup.effects.masking : setup.effects.shadowing) = number == 1;
        else if (name == "cells")
            return keepGrid(number);
        else
            return false;
        return setup.channels == 1 || setup.channels == 3 || setup.channels == 9 || name == "fingerprint";
    }

    /// The grid is whole and what a table may hold; so many cells stand in the file, each a line.
    bool keepGrid(std::uint64_t cells)
    {
        double product = 1.0;
        for (const auto& axis : run_.setup.shape.axes)
            product *= static_cast<double>(axis.size());
        if (product != static_cast<double>(cells) || cells > 20'000'000 || cells == 0)
            return false;
        Table table;
        table.system = AngleSystem::Isotropic;
        table.axes = run_.setup.shape.axes;
        table.values.assign(cells, 0.0);
        if (!checkedTable(table))
            return false;
        run_.cells.resize(cells);
        return true;
    }

    Result<void> takeCell(LabCell& cell)
    {
        const auto line = lines_.next();
        if (!line)
            return wrong("ends before its last cell; it was not written to its end");
        const auto pieces = words(*line);
        const std::size_t channels = run_.setup.channels;
        const auto batches = pieces.empty() ? std::nullopt : wholeNumber(pieces[0]);
        const auto wanted = pieces.size() < 2 ? std::nullopt : wholeNumber(pieces[1]);
        const auto numbers = numbersInWords(*line);
        if (!batches || !wanted || !numbers || numbers->size() != 2 + 2 * channels)
            return wrong("a cell is two counts, then " + std::to_string(2 * channels) + " numbers");
        cell.batches = *batches;
        cell.wanted = *wanted;
        std::copy_n(numbers->begin() + 2, channels, cell.mean.begin());
        std::copy_n(numbers->begin() + 2 + static_cast<std::ptrdiff_t>(channels), channels, cell.squares.begin());
        return {};
    }

    Lines lines_;
    const std::string& file_;
    LabRun run_;
};

} // namespace

std::string checkpointText(const LabRun& run)
{
    const LabSetup& setup = run.setup;
    std::string text(firstLine);
    text += "\nsurface " + setup.surface + "\nfingerprint " + std::to_string(run.fingerprint) + "\nmodel " +
            setup.model + "\n";
    appendNumbers(text, "values", setup.values);
    text += "channels " + std::to_string(setup.channels) + "\nbounces " + std::to_string(setup.effects.bounces) +
            "\nmasking " + (setup.effects.masking ? "1" : "0") + "\nshadowing " +
            (setup.effects.shadowing ? "1" : "0") + "\nazimuth " +
            (setup.azimuth ? shortest(*setup.azimuth) : "mixed") + "\nseed " + std::to_string(setup.seed) + "\n";
    for (std::size_t axis = 0; axis < 3; ++axis)
        appendNumbers(text, angleNames(AngleSystem::Isotropic)[axis], setup.shape.axes[axis]);
    text += "lost " + std::to_string(run.lost) + "\ncells " + std::to_string(run.cells.size()) + "\n";
    for (const LabCell& cell : run.cells) {
        text += std::to_string(cell.batches) + " " + std::to_string(cell.wanted);
        for (const Channels* numbers : {&cell.mean, &cell.squares})
            for (std::size_t c = 0; c < setup.channels; ++c)
                text.append(" ").append(shortest((*numbers)[c]));
        text += '\n';
    }
    return text;
}

Result<LabRun> readCheckpoint(std::string_view text, const std::string& file)
{
    return Reader(text, file).read();
}

} // namespace reflectance
