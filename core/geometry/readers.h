// The checked readers, one per format. They trust nothing: no index, no count, no length. What can be kept is kept and
// the rest is counted in the warnings; an Error means that nothing of use could be read.
#pragma once

#include "core/base/file.h"
#include "core/base/result.h"
#include "core/geometry/polygon_soup.h"
#include "core/geometry/text_parts.h"
#include "core/geometry/warnings.h"

#include <atomic>
#include <optional>
#include <string_view>

namespace reflectance {

struct ReadContext {
    std::string file; ///< as errors name it
    Warnings warnings;
    std::atomic<double>* progress = nullptr;   ///< 0 .. 1, of the whole way from file to mesh
    const std::atomic<bool>* cancel = nullptr; ///< set by another thread to stop
    int threads = 1;                           ///< that read at the same time; the result is the same for any number

    double stepBegins = 0.0, stepEnds = 1.0; ///< the present step's share of `progress`

    /// To be called now and then, with how much of the step is done (0 .. 1); false when the work is to stop.
    [[nodiscard]] bool goOn(double done) const
    {
        if (progress)
            progress->store(stepBegins + done * (stepEnds - stepBegins), std::memory_order_relaxed);
        return !isCancelled();
    }

    [[nodiscard]] bool isCancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }

    [[nodiscard]] Error stopped() const { return {"reading was stopped", file, 0}; }
};

/// Wavefront OBJ: v, vn and f with 1-based or negative indices; everything else is stepped over.
Result<PolygonSoup> readObj(TextParts text, ReadContext& context);
/// Stanford PLY: ascii, binary little-endian and binary big-endian; any scalar types, elements in any order.
Result<PolygonSoup> readPly(std::string_view bytes, ReadContext& context);
/// Geomview OFF in text, with the prefixes ST, C and N.
Result<PolygonSoup> readOff(std::string_view text, ReadContext& context);
/// STL, ascii and binary; equal positions become one vertex.
Result<PolygonSoup> readStl(std::string_view bytes, ReadContext& context);

/// How much of a file tells whether it can be a mesh at all.
inline constexpr std::size_t headOfFile = 4096;

/// Refuses what its first `headOfFile` bytes show to be no mesh, before gigabytes are read; nothing when it may be one.
[[nodiscard]] std::optional<Error> whyNoMesh(const FileHead& head, std::string_view extension, const std::string& file);

/// Whether the first `headOfFile` bytes leave no doubt that the file is OBJ, which can be read without holding all of it.
[[nodiscard]] bool isSurelyObj(const FileHead& head, std::string_view extension);

/// Finds out the format from the contents, `extension` ("obj") breaking the tie, and reads.
Result<PolygonSoup> readSoup(std::string_view bytes, std::string_view extension, ReadContext& context);

} // namespace reflectance
