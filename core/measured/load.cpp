#include "core/measured/load.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/measured/lines.h"
#include "core/measured/readers.h"
#include "core/measured/tensor_file.h"

#include <algorithm>
#include <filesystem>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t headBytes = 4096;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

enum class Format { Csv, OpenMaterial, Merl, Rgl, Cornell, Zemax, CuretGeometries, CuretSurfaces };

std::string_view firstContent(std::string_view text)
{
    Lines lines(text);
    while (const auto line = lines.next())
        if (const auto content = trimmed(*line); !content.empty() && content.front() != '#')
            return content;
    return {};
}

/// CUReT's tables are rows that begin with their number, 1 first: five columns, or one more than there are geometries.
std::optional<Format> curetTable(std::string_view line)
{
    const auto fields = words(line);
    const auto isNumber = [](std::string_view word) { return parseNumber(word).has_value(); };
    if (fields.size() < 5 || fields.front() != "1" || !std::all_of(fields.begin(), fields.end(), isNumber))
        return std::nullopt;
    return fields.size() == 5 ? Format::CuretGeometries : Format::CuretSurfaces;
}

bool isZemaxWord(std::string_view word)
{
    static constexpr std::string_view known[] = {"source",         "symmetry",         "spectralcontent",
                                                 "scattertype",    "angleofincidence", "samplerotation",
                                                 "scatterazimuth", "scatterradial"};
    return std::find(std::begin(known), std::end(known), lowered(word)) != std::end(known);
}

std::optional<Format> formatOf(std::string_view bytes)
{
    if (bytes.starts_with(tensorFileMagic.substr(0, 11)))
        return Format::Rgl;
    if (bytes.substr(0, headBytes).find('\0') != std::string_view::npos)
        return looksLikeMerl(bytes) ? std::optional(Format::Merl) : std::nullopt;
    const std::string_view line = firstContent(bytes);
    if (line.empty())
        return std::nullopt;
    if (line.front() == '{' || line.front() == '[')
        return Format::OpenMaterial;
    if (line.find(',') != std::string_view::npos)
        return Format::Csv;
    if (const auto curet = curetTable(line))
        return curet;
    const auto fields = words(line);
    if (isZemaxWord(fields.front()))
        return Format::Zemax;
    return parseInteger(fields.front()) ? std::optional(Format::Cornell) : std::nullopt;
}

Error unknownFormat(std::string_view bytes, const std::string& file)
{
    if (bytes.empty())
        return {"is empty; choose a measured table", file};
    return {"is no measured table of a known format; CSV, OpenMATERIAL 3D, MERL, RGL, Cornell, CUReT and Zemax can be "
            "read",
            file};
}

/// The file that CUReT's other half stands in.
std::string besideOf(const std::string& path, const char* name)
{
    return (fs::path(path).parent_path() / name).string();
}

Result<Measurement> loadCuret(const std::string& bytes, const std::string& path, Format format,
                              const ReadOptions& options)
{
    const bool isSurfaces = format == Format::CuretSurfaces;
    const std::string other = besideOf(path, isSurfaces ? "table.txt" : "abrdf.dat");
    const auto rest = readWholeFile(other);
    if (!rest)
        return Error{"is one half of a CUReT measurement; put the other half, " + fs::path(other).filename().string() +
                         ", beside it",
                     path};
    if (isSurfaces)
        return readCuret(*rest, other, bytes, {path, options});
    return readCuret(bytes, path, *rest, {other, options});
}

} // namespace

Result<Measurement> readMeasurement(std::string_view bytes, const std::string& file, const ReadOptions& options)
{
    if (bytes.starts_with(byteOrderMark))
        bytes.remove_prefix(byteOrderMark.size());
    const ReadContext context{file, options};
    const auto format = formatOf(bytes);
    if (!format)
        return unknownFormat(bytes, file);
    switch (*format) {
    case Format::Csv:
        return readCsv(bytes, context);
    case Format::OpenMaterial:
        return readOpenMaterial(bytes, context);
    case Format::Merl:
        return readMerl(bytes, context);
    case Format::Rgl:
        return readRgl(bytes, context);
    case Format::Cornell:
        return readCornell(bytes, context);
    case Format::Zemax:
        return readZemax(bytes, context);
    case Format::CuretGeometries:
    case Format::CuretSurfaces:
        return Error{"is one half of a CUReT measurement; open it as a file, with the other half beside it", file};
    }
    return unknownFormat(bytes, file);
}

Result<Measurement> loadMeasurement(const std::string& path, const ReadOptions& options)
{
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    const auto format = formatOf(*bytes);
    if (format == Format::CuretGeometries || format == Format::CuretSurfaces)
        return loadCuret(*bytes, path, *format, options);
    return readMeasurement(*bytes, path, options);
}

} // namespace reflectance
