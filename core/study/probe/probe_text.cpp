#include "core/base/text.h"
#include "core/study/probe/probe.h"

namespace reflectance {
namespace {

std::string triple(const Vec3d& v, int digits = 5)
{
    return general(v.x, digits) + "  " + general(v.y, digits) + "  " + general(v.z, digits);
}

std::string valueText(const std::vector<double>& numbers)
{
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : "  ") + general(number, 5);
    return text;
}

std::string lightText(const ProbedLight& light)
{
    std::string text = "light " + std::to_string(light.index + 1) + "  " + light.name + "\n";
    if (light.kind == LightKind::Point)
        text += "  sent         " + triple(light.sent) + ", over r^2 at r = " + general(light.distance, 5) + "\n";
    text += "  I            " + triple(light.I) + "\n  L            " + triple(light.L) + "\n  N.L          " +
            general(light.cosine, 6) + "\n  R.V          " + general(light.mirrorCosine, 6) + "\n";
    for (const walked::AccountLine& line : light.account.lines) {
        text += "  line " + std::to_string(line.line) + "  " + line.name + " = " + line.expression + "\n";
        if (line.filled != line.expression)
            text += "      = " + line.filled + "\n";
        text += "      = " + valueText(line.numbers) + "\n";
        for (const std::string& note : line.notes)
            text += "      " + note + "\n";
    }
    for (const ProbedTerm& term : light.terms)
        text += "  " + term.name + "  " + triple(term.value) + "   (" + term.source + ")\n";
    return text + "  adds         " + triple(light.value) + "\n";
}

std::string csvOf(const Vec3d& v)
{
    return "," + general(v.x, 17) + "," + general(v.y, 17) + "," + general(v.z, 17);
}

/// No field holds a comma or a line end.
std::string field(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '\n' || c == '"')
            c = ' ';
    return text;
}

} // namespace

std::string probeText(const Probe& probe)
{
    std::string text = "pixel " + general(probe.point.x, 6) + ", " + general(probe.point.y, 6) + "   " + probe.model +
                       "\n" + probe.formula + "\n" + (probe.convention.empty() ? "" : probe.convention + "\n") +
                       "\nLIGHT AND SURFACE\n";
    text += "  P            " + triple(probe.point.P) + "\n  N            " + triple(probe.point.N) +
            "\n  V            " + triple(probe.V) + "\n  N.V          " + general(probe.NV, 6) + "\n";
    for (const ProbedLight& light : probe.lights)
        text += lightText(light);
    if (probe.surroundings)
        text += "surroundings\n  adds         " + triple(*probe.surroundings) + "\n";
    text += "  sum          " + triple(probe.value) + "\n\nSENSOR\n  exposed      " + triple(probe.exposed) +
            "   (times " + general(probe.gain, 5) + ")\n";
    constexpr const char* channels[] = {"red", "green", "blue"};
    for (std::size_t i = 0; i < 3; ++i)
        if (probe.clipped[i])
            text += std::string("  clipped      ") + channels[i] + "\n";
    text += "  encoded      " + triple(probe.encoded) + "\n  code         ";
    for (const std::uint8_t code : probe.codes)
        text += std::to_string(code) + "  ";
    while (text.ends_with(' '))
        text.pop_back();
    return text + "\n";
}

std::string probeCsv(const std::vector<Probe>& probes)
{
    std::string text = "probe,x,y,model,light,Px,Py,Pz,Nx,Ny,Nz,Vx,Vy,Vz,Lx,Ly,Lz,I_r,I_g,I_b,N.L,R.V,adds_r,adds_g,"
                       "adds_b,sum_r,sum_g,sum_b,code_r,code_g,code_b\n";
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const Probe& probe = probes[i];
        std::string codes;
        for (const std::uint8_t code : probe.codes)
            codes += "," + std::to_string(code);
        for (const ProbedLight& light : probe.lights)
            text += (probe.name.empty() ? std::to_string(i + 1) : field(probe.name)) + "," +
                    general(probe.point.x, 17) + "," + general(probe.point.y, 17) + "," + field(probe.model) + "," +
                    field(light.name) + csvOf(probe.point.P) + csvOf(probe.point.N) + csvOf(probe.V) + csvOf(light.L) +
                    csvOf(light.I) + "," + general(light.cosine, 17) + "," + general(light.mirrorCosine, 17) +
                    csvOf(light.value) + csvOf(probe.value) + codes + "\n";
    }
    return text;
}

} // namespace reflectance
