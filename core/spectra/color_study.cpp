#include "core/spectra/color_study.h"

#include "core/image/colour_difference.h"
#include "core/spectra/builtin.h"

#include <algorithm>

namespace reflectance {
namespace {

Result<SpectrumTriple> sensorsOf(const ColorQuestion& question)
{
    if (question.sensor != "gaussian")
        return sensorNamed(question.sensor);
    const auto white = lightNamed("E");
    if (!white)
        return white.error();
    return balanced(gaussianSensor(question.crossing), *white);
}

const JudgedLight* findLight(const std::vector<JudgedLight>& lights, const std::string& name)
{
    const auto found = std::find_if(lights.begin(), lights.end(), [&](const JudgedLight& l) { return l.name == name; });
    return found == lights.end() ? nullptr : &*found;
}

} // namespace

Vec3d displayed(const Mat3d& toXyz, const Vec3d& response, const Vec3d& white)
{
    const Vec3d one = xyzOf({1.0, 0.0, 0.0});
    const Vec3d two = xyzOf({0.0, 1.0, 0.0});
    const Vec3d three = xyzOf({0.0, 0.0, 1.0});
    static const Mat3d fromXyz = inverse(transposed({{one, two, three}}));
    const Vec3d own = toXyz * white;
    const Vec3d D65 = xyzOf(Vec3d(1.0));
    const Vec3d XYZ = toXyz * response;
    const auto share = [](double value, double of) { return of > 0.0 ? value / of : 0.0; };
    return fromXyz * (Vec3d(share(XYZ.x, own.x), share(XYZ.y, own.y), share(XYZ.z, own.z)) * D65);
}

Result<ColorAnswer> answered(const ColorQuestion& question)
{
    auto sensors = sensorsOf(question);
    if (!sensors)
        return sensors.error();
    auto primaries = primariesNamed(question.primaries);
    if (!primaries)
        return primaries.error();
    AlsoOnGrid also;
    also.reflectances = colorChecker();
    const auto other = lightNamed(question.under);
    if (other)
        also.lights.push_back(*other);
    auto system = makeColorSystem(*primaries, *sensors, also);
    if (!system)
        return system.error();
    ColorAnswer answer{*std::move(sensors), *std::move(primaries), *std::move(system), {}, {}, {}, {}, {}};
    const std::vector<JudgedLight> inSpan = lightsInSpan(answer.system);
    const JudgedLight* own = findLight(inSpan, question.under);
    if (!own && !other)
        return other.error();
    answer.light = own ? *own : judgedLight(answer.system, *other);
    for (const Spectrum& patch : colorChecker())
        answer.patches.push_back(judgedSurface(answer.system, patch));
    answer.prices = pricesOfCheats(answer.system, answer.patches, {answer.light});
    const Mat3d toXyz = xyzFromSensor(answer.system);
    for (const JudgedSurface& patch : answer.patches) {
        const JudgedLight& light = answer.light;
        answer.truth.push_back(displayed(toXyz, answer.system.response(light.power, patch.S), light.white));
        for (std::size_t c = 0; c < answer.byCheat.size(); ++c)
            answer.byCheat[c].push_back(
                displayed(toXyz, matrixBy(allCheats[c], answer.system, patch) * light.seen, light.white));
    }
    return answer;
}

} // namespace reflectance
