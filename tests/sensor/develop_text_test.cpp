// The sensor's shared text in both precisions.
#include "core/sensor/sensor.h"
#include "sensor_texts.gen.h"

#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

TEST(DevelopText, FloatKeepsEveryCodeToo)
{
    texts::Develop<float> text;
    for (int code = 0; code < 256; ++code) {
        const auto linear = static_cast<float>(decodeSrgb(code / 255.0));
        EXPECT_EQ(quantised(double{text.developChannel(linear)}), code);
    }
}

TEST(DevelopText, FloatAndDoubleAgree)
{
    texts::Develop<float> inFloat;
    texts::Develop<double> inDouble;
    for (int i = 0; i <= 4096; ++i) {
        const float linear = static_cast<float>(i) / 4096.0F;
        // Three roundings of numbers near 1, and pow to 1 ulp: 4 * 2^-24.
        EXPECT_NEAR(double{inFloat.developChannel(linear)}, inDouble.developChannel(double{linear}), 2.4e-7);
    }
}

TEST(DevelopText, ChannelsDoNotMix)
{
    const Vec3d code = texts::Develop<double>().develop({0.5, -1.0, std::numeric_limits<double>::quiet_NaN()});
    EXPECT_EQ(code, Vec3d(encodeSrgb(0.5), 0.0, 0.0));
}

TEST(DevelopText, StartsUnexposed)
{
    EXPECT_EQ(texts::Develop<float>().exposure, 0.0F);
}

} // namespace
} // namespace reflectance
