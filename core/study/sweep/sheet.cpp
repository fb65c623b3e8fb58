#include "core/study/sweep/sheet.h"

#include "core/base/text.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

/// A field of a CSV line (RFC 4180): quoted where it holds a comma or a quote.
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// FNV-1a, 64 bits: tells scenes apart, not meant to withstand malice.
std::string digestOf(const std::string& text)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    return digits.data();
}

Error notWritable(const std::string& path)
{
    return {"cannot be written (" + std::string(std::strerror(errno)) + "); choose another place", path};
}

/// What an earlier run left, as far as it is whole.
struct Found {
    std::uintmax_t bytes = 0; ///< of whole lines
    std::uint64_t cells = 0, failed = 0;
    bool hasHead = false;
};

Result<Found> earlierLines(const std::string& path, const Study& study, bool timing)
{
    Found found;
    std::ifstream file(path, std::ios::binary);
    const Error foreign{
        "holds the figures of another study, or of this one before it was changed; choose another --out, or "
        "remove the file",
        path};
    std::string line;
    while (std::getline(file, line) && !file.eof()) { // eof: a line without its end was torn
        if (!found.hasHead) {
            if (line + "\n" != sheetHead(study, timing))
                return foreign;
            found.hasHead = true;
        } else {
            const std::string inputs =
                found.cells < cellCount(study) ? inputsOf(cellAt(study, found.cells)) : std::string("none");
            if (!line.starts_with(inputs))
                return Error{foreign.message, path, static_cast<long>(found.cells) + 2};
            found.failed += line.substr(inputs.size()).starts_with(",") ? 1U : 0U; // no figure follows
            ++found.cells;
        }
        found.bytes += line.size() + 1;
    }
    if (!found.hasHead && !line.empty() && !sheetHead(study, timing).starts_with(line))
        return foreign; // not a torn head, but somebody's file
    return found;
}

} // namespace

std::string sheetHead(const Study& study, bool timing)
{
    std::string head = "cell,";
    for (const StudyAxis& axis : study.axes)
        if (hasColumn(axis))
            head += field(axis.name) + ",";
    head +=
        "width,height,samples,renderer,scene,covered,mean,max,negative,non_finite,rmse,max_abs,de2000_mean,de2000_max,"
        "flip,";
    return head + (timing ? "ms,error\n" : "error\n");
}

std::string inputsOf(const Cell& cell)
{
    std::string text = std::to_string(cell.index) + ",";
    for (const std::string& label : cell.labels)
        text += field(label) + ",";
    const RenderSettings& s = cell.settings;
    std::string scene = cell.scene;
    if (cell.orbit)
        scene += shortest((*cell.orbit)[0]) + " " + shortest((*cell.orbit)[1]);
    return text + std::to_string(s.width) + "," + std::to_string(s.height) + "," +
           std::to_string(s.samplesPerAxis * s.samplesPerAxis) + "," + std::string(nameOf(cell.renderer)) + "," +
           digestOf(scene) + ",";
}

std::string resultText(const CellResult& result, bool timing)
{
    const Figures& f = result.figures;
    if (!result.error.empty())
        return std::string(timing ? 11 : 10, ',') + field(result.error) + "\n";
    std::string text = shortest(f.covered) + "," + shortest(f.mean) + "," + shortest(f.largest) + "," +
                       std::to_string(f.negative) + "," + std::to_string(f.nonFinite) + ",";
    for (const double figure : {f.rmse, f.maxAbs, f.deltaEMean, f.deltaEMax, f.flip})
        text += shortest(figure) + ",";
    return text + (timing ? general(f.milliseconds, 4) + ",\n" : "\n");
}

Result<Sheet> Sheet::open(const std::string& path, const Study& study, bool timing)
{
    std::error_code ignored;
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        return Error{"is not a file but a folder, device or pipe; name a file for the figures", path};
    Sheet sheet(path, timing);
    sheet.file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (sheet.file_ < 0)
        return notWritable(path);
    if (::flock(sheet.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return Error{"another sweep is writing this file; wait for it, or choose another --out", path};
    const auto found = earlierLines(path, study, timing); // after the lock: nobody else writes
    if (!found)
        return found.error();
    if (::ftruncate(sheet.file_, static_cast<off_t>(found->bytes)) != 0)
        return notWritable(path);
    sheet.cells_ = found->cells;
    sheet.failed_ = found->failed;
    if (!found->hasHead)
        if (const auto written = sheet.write(sheetHead(study, timing)); !written)
            return written.error();
    return sheet;
}

Sheet::Sheet(Sheet&& other) noexcept
    : path_(std::move(other.path_)), timing_(other.timing_), file_(std::exchange(other.file_, -1)),
      cells_(other.cells_), failed_(other.failed_)
{
}

Sheet& Sheet::operator=(Sheet&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(timing_, other.timing_);
    std::swap(file_, other.file_);
    std::swap(cells_, other.cells_);
    std::swap(failed_, other.failed_);
    return *this;
}

Sheet::~Sheet()
{
    if (file_ >= 0)
        ::close(file_);
}

Result<void> Sheet::write(const std::string& line) const
{
    const ssize_t written = ::write(file_, line.data(), line.size());
    if (written != static_cast<ssize_t>(line.size())) {
        if (written >= 0) // a full disk takes the beginning; the next run drops it
            errno = ENOSPC;
        return notWritable(path_);
    }
    return {};
}

Result<void> Sheet::append(const Cell& cell, const CellResult& result)
{
    if (auto written = write(inputsOf(cell) + resultText(result, timing_)); !written)
        return written;
    ++cells_;
    failed_ += result.error.empty() ? 0U : 1U;
    return {};
}

} // namespace reflectance
