#include "core/render/pictures/backend_choice.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/reflectance/kernel_tables.h"
#include "core/render/gl/gl_renderer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <thread>

namespace reflectance {
namespace {

constexpr std::size_t mostTriangles = 10'000'000;
constexpr std::size_t mostSamples = 20'000'000;

/// Times hold for this program on this machine.
std::string firstLine()
{
    return "reflectance backends 1, " + std::string(programVersion()) + ", " +
           std::to_string(std::thread::hardware_concurrency()) + " cores, " + lanesName();
}

/// Nothing where no context opens.
std::optional<std::string> rendererHere(ContextKind kind)
{
    const auto context = openHeadless(kind);
    if (!context)
        return std::nullopt;
    const auto renderer = GlRenderer::create((*context)->loader());
    return renderer ? std::optional(renderer->description()) : std::nullopt;
}

/// With all that a picture needs: GL's context and the way back from its memory too.
std::optional<double> onceTimed(const Scene& scene, const RenderSettings& settings, RenderPlan plan, Backend backend,
                                Progress* progress)
{
    plan.backend = backend;
    plan.alsoGeneral = false;
    const auto start = std::chrono::steady_clock::now();
    if (!renderPicture(scene, settings, plan, progress))
        return std::nullopt;
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The better of two where that takes no time: a first picture also compiles shaders, which GL's driver keeps, and is the first
/// to touch the memory that it needs.
std::optional<double> wholeTime(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                                Backend backend, Progress* progress)
{
    constexpr double soon = 300.0;
    const auto first = onceTimed(scene, settings, plan, backend, progress);
    if (!first || *first >= soon)
        return first;
    const auto second = onceTimed(scene, settings, plan, backend, progress);
    return second ? std::min(*first, *second) : second;
}

std::optional<BackendTimes> measured(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                                     Progress* progress)
{
    const auto gl = wholeTime(scene, settings, plan, Backend::Gl, progress);
    const auto cpu = wholeTime(scene, settings, plan, Backend::Cpu, progress);
    if (progress != nullptr)
        progress->done = 0.0; // the picture itself is still to come
    if (!gl || !cpu)
        return std::nullopt;
    return BackendTimes{*gl, *cpu};
}

std::optional<BackendTimes> timesOf(std::string_view glTime, std::string_view cpuTime)
{
    const auto gl = parseNumber(glTime);
    const auto cpu = parseNumber(cpuTime);
    if (!gl || !cpu || !(*gl > 0.0) || !(*cpu > 0.0))
        return std::nullopt;
    return BackendTimes{*gl, *cpu};
}

/// Five words: the class's three and the two times.
std::optional<BackendTimes> timesOfLine(std::string_view line, const std::string& sizeClass)
{
    if (!line.starts_with(sizeClass + " "))
        return std::nullopt;
    const auto words = split(line.substr(sizeClass.size() + 1), ' ');
    return words.size() == 2 ? timesOf(words[0], words[1]) : std::nullopt;
}

} // namespace

std::string sizeClass(std::size_t triangles, const RenderSettings& settings, int frames)
{
    const auto step = [](std::size_t count) { return std::to_string((std::bit_width(count) + 1) / 2); };
    return "triangles-4^" + step(triangles) + " samples-4^" + step(settings.samples()) +
           (frames > 1 ? " frames" : " frame");
}

BackendChoice soonerOf(const BackendTimes& times)
{
    const std::string why =
        "measured here once: GL " + general(times.gl, 3) + " ms, CPU " + general(times.cpu, 3) + " ms";
    constexpr double worthIt = 0.75;
    return {times.gl > worthIt * times.cpu ? Backend::Cpu : Backend::Auto, why};
}

std::optional<BackendTimes> timesIn(std::string_view file, const std::string& sizeClass)
{
    const auto lines = split(file, '\n');
    if (lines.empty() || lines.front() != firstLine())
        return std::nullopt;
    for (const std::string_view line : lines)
        if (const auto times = timesOfLine(line, sizeClass))
            return times;
    return std::nullopt;
}

bool isAlwaysTheCpu(std::string_view file)
{
    const auto lines = split(file, '\n');
    if (lines.empty() || lines.front() != firstLine())
        return false;
    bool some = false;
    for (const std::string_view line : lines) {
        const auto words = split(line, ' ');
        const auto times = words.size() == 5 ? timesOf(words[3], words[4]) : std::nullopt;
        if (times && soonerOf(*times).backend != Backend::Cpu)
            return false;
        some = some || times;
    }
    return some;
}

std::string withTimes(std::string_view file, const std::string& sizeClass, const BackendTimes& times)
{
    const bool isOurs = file.starts_with(firstLine() + "\n");
    return (isOurs ? std::string(file) : firstLine() + "\n") + sizeClass + " " + general(times.gl, 6) + " " +
           general(times.cpu, 6) + "\n";
}

BackendChoice soonerBackend(const Scene& scene, const RenderSettings& settings, const RenderPlan& plan,
                            const std::filesystem::path& file, Progress* progress)
{
    if (file.empty())
        return {Backend::Auto, ""};
    const std::size_t triangles = scene.mesh->triangles.size();
    const std::string size = sizeClass(triangles, settings, plan.frames);
    const auto known = readWholeFile(file.string(), mostBackendBytes);
    const std::string text = known ? *known : std::string();
    if (const auto times = timesIn(text, size))
        return soonerOf(*times);
    if (triangles > mostTriangles || settings.samples() > mostSamples)
        return {Backend::Auto, "too large to try both"};
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    if (failed || !checkWritable(file.string()))
        return {Backend::Auto, "what was measured could not be kept"};
    const auto renderer = rendererHere(plan.context);
    if (!renderer)
        return {Backend::Auto, "no OpenGL context opens"};
    if (!isSoftware(*renderer))
        return {Backend::Auto, "drawn by " + *renderer};
    const auto times = measured(scene, settings, plan, progress);
    if (!times || !writeAtomically(file.string(), withTimes(text, size, *times)))
        return {Backend::Auto, "what was measured could not be kept"};
    return soonerOf(*times);
}

} // namespace reflectance
