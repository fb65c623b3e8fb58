#include "core/study/goniometer/micro_surface.h"

#include "core/base/text.h"
#include "core/study/goniometer/counter_random.h"
#include "core/study/goniometer/surface_makers.h"

#include <algorithm>
#include <bit>

namespace reflectance {
namespace {

struct Maker {
    std::string_view name;
    Result<std::vector<Patch>> (*make)(std::string_view words);
};
constexpr Maker makers[] = {
    {"flat", makeFlat}, {"vgrooves", makeVGrooves}, {"gaussian", makeGaussian}, {"scratches", makeScratches}};

/// Before and after the last colon, where "name=value" stands behind it; a path may hold colons.
std::pair<std::string, std::string> divided(const std::string& text)
{
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || text.find('=', colon) == std::string::npos)
        return {text, ""};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

bool endsLikeAPicture(const std::string& path)
{
    const std::string name = lowered(path);
    return name.ends_with(".png") || name.ends_with(".exr") || name.ends_with(".pfm") || name.ends_with(".hdr");
}

Result<std::vector<Patch>> patchesOf(const std::string& text)
{
    const auto [name, words] = divided(text);
    for (const Maker& maker : makers)
        if (name == maker.name)
            return maker.make(words);
    return endsLikeAPicture(name) ? patchesFromPicture(name, words) : patchesFromMesh(name, words);
}

} // namespace

std::uint64_t MicroSurface::fingerprint() const
{
    std::uint64_t print = patches.size();
    for (const Patch& patch : patches)
        for (const Vec3d& p : patch.positions)
            for (const double coordinate : {p.x, p.y, p.z})
                print = scrambled(print ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) + 1;
    return print;
}

std::size_t MicroSurface::triangles() const
{
    std::size_t count = 0;
    for (const Patch& patch : patches)
        count += patch.triangles.size();
    return count;
}

double MicroSurface::slope() const
{
    double sum = 0.0;
    for (const Patch& patch : patches)
        sum += rmsSlope(patch) * rmsSlope(patch);
    return std::sqrt(sum / static_cast<double>(patches.size()));
}

Result<MicroSurface> microSurface(const std::string& text)
{
    auto patches = patchesOf(text);
    if (!patches) // a file's own sentences name the file; those of generators the text
        return patches.error().file.empty() ? Error{patches.error().message, text} : patches.error();
    return MicroSurface{text, *std::move(patches)};
}

const std::vector<SurfaceKind>& surfaceKinds()
{
    static const std::vector<SurfaceKind> kinds{
        {"Grooves of Oren and Nayar", "vgrooves:sigma=30",
         "Symmetric V-grooves in all directions, their slopes spread as in Oren and Nayar's derivation; sigma in "
         "degrees."},
        {"Grooves of one slope", "vgrooves:slope=35",
         "Symmetric V-grooves whose walls all rise by the same angle, in degrees."},
        {"Gaussian heights", "gaussian:sigma=20,correlation=0.05",
         "Random heights; sigma, in degrees, is the standard deviation of the slope along a line, correlation their "
         "extent in periods."},
        {"Scratches", "scratches:sigma=20,correlation=0.02", "Random grooves that all run one way: brushed metal."},
        {"Flat", "flat",
         "One flat facet: gives back the facets' own model, which shows that the instrument is right."}};
    return kinds;
}

} // namespace reflectance
