#include "core/base/check.h"
#include "core/measured/bytes.h"
#include "core/measured/merl.h"
#include "core/measured/write.h"

#include <limits>
#include <numbers>

namespace reflectance {
namespace {

/// The number that, times the scale, gives f again: the quotient may miss by its last bit.
double rawOf(double f, double scale)
{
    const double quotient = f / scale;
    for (const double end : {0.0, std::numeric_limits<double>::infinity()})
        if (const double next = std::nextafter(quotient, end); quotient * scale != f && next * scale == f)
            return next;
    return quotient;
}

} // namespace

std::string merlBytes(const Table& table)
{
    CHECK_EQ(static_cast<int>(table.system), static_cast<int>(AngleSystem::HalfDifference));
    CHECK_LE(table.channels, std::size_t{3});
    const merl::Size size;
    const auto thetaH = merl::thetaHNodes(size.thetaH);
    const auto thetaD = merl::evenNodes(size.thetaD, std::numbers::pi / 2.0);
    const auto phiD = merl::evenNodes(size.phiD, std::numbers::pi);
    std::string planes[3];
    for (std::size_t h = 0; h < size.thetaH; ++h)
        for (std::size_t d = 0; d < size.thetaD; ++d)
            for (std::size_t p = 0; p < size.phiD; ++p) {
                const auto f = valueAt(table, {thetaH[h], thetaD[d], phiD[p]});
                for (std::size_t c = 0; c < 3; ++c) {
                    // Negative means "not measured", so a negative f can only be 0.
                    const double value = f ? std::fmax((*f)[table.channels == 1 ? 0 : c], 0.0) : 0.0;
                    appendLittleEndian(planes[c], f ? rawOf(value, merl::scale[c]) : -1.0);
                }
            }
    std::string bytes;
    for (const std::size_t dimension : {size.thetaH, size.thetaD, size.phiD})
        appendLittleEndian(bytes, static_cast<std::int32_t>(dimension));
    return bytes + planes[0] + planes[1] + planes[2];
}

} // namespace reflectance
