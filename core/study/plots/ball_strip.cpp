#include "core/base/text.h"
#include "core/chart/csv_field.h"
#include "core/chart/svg_writer.h"
#include "core/image/formats.h"
#include "core/study/plots/balls.h"

#include <algorithm>

namespace reflectance {
namespace {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? letters[group >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=';
    }
    return out;
}

std::vector<std::uint8_t> developedBall(const Ball& ball, const Sensor& sensor)
{
    return develop(ball.picture, sensor).rgb;
}

} // namespace

std::vector<std::uint8_t> developedStrip(const BallStrip& strip)
{
    const auto size = static_cast<std::size_t>(strip.size);
    const std::size_t rowBytes = 3 * size * strip.balls.size();
    std::vector<std::uint8_t> rgb(rowBytes * size);
    for (std::size_t i = 0; i < strip.balls.size(); ++i) {
        const std::vector<std::uint8_t> one = developedBall(strip.balls[i], strip.sensor);
        for (std::size_t y = 0; y < size; ++y)
            std::copy_n(one.begin() + static_cast<std::ptrdiff_t>(3 * size * y), 3 * size,
                        rgb.begin() + static_cast<std::ptrdiff_t>(rowBytes * y + 3 * size * i));
    }
    return rgb;
}

std::string svgOf(const BallStrip& strip, int width, int height)
{
    SvgWriter svg(width, height);
    svg.text(16, 22, strip.title, SvgWriter::Anchor::Start, 14, 0x101010);
    const auto count = static_cast<double>(std::max<std::size_t>(1, strip.balls.size()));
    const double side = std::min((width - 32.0) / count, height - 80.0);
    double x = 16;
    for (const Ball& ball : strip.balls) {
        const std::string png = encodedPng(strip.size, strip.size, developedBall(ball, strip.sensor));
        svg.image(x, 36, side - 4, side - 4, "data:image/png;base64," + base64(png));
        svg.rectangle(x, 36 + side, side - 4, 3, ball.color);
        svg.text(x + side / 2, 36 + side + 18, ball.name, SvgWriter::Anchor::Middle, 11);
        x += side;
    }
    return svg.finished();
}

std::string csvOf(const BallStrip& strip)
{
    std::string out = "series,x,red,green,blue\n";
    for (const Ball& ball : strip.balls)
        for (int x = 0; x < strip.size; ++x) {
            const float* const rgb = ball.picture.at(x, strip.size / 2);
            out += csvField(ball.name) + ',' + shortest((2.0 * x + 1.0) / strip.size - 1.0);
            for (int channel = 0; channel < 3; ++channel)
                out += ',' + shortest(static_cast<double>(rgb[channel]));
            out += '\n';
        }
    return out;
}

} // namespace reflectance
