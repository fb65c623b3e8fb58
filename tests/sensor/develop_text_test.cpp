// The sensor's shared text in both precisions.
#include "core/sensor/sensor.h"
#include "sensor_texts.gen.h"

#include <gtest/gtest.h>
#include <limits>

namespace reflectance {
namespace {

template <class T> T developChannel(texts::Develop<T>& text, T radiance)
{
    return text.develop(Vec3<T>(radiance), 0, 0, 1, 1).x;
}

TEST(DevelopText, FloatKeepsEveryCodeToo)
{
    texts::Develop<float> text{};
    for (int code = 0; code < 256; ++code) {
        const auto linear = static_cast<float>(decodeSrgb(code / 255.0));
        EXPECT_EQ(quantised(double{developChannel(text, linear)}), code);
    }
}

TEST(DevelopText, FloatAndDoubleAgree)
{
    texts::Develop<float> inFloat{};
    texts::Develop<double> inDouble{};
    inFloat.levels = 0.0F;
    inDouble.levels = 0.0;
    for (int i = 0; i <= 4096; ++i) {
        const float linear = static_cast<float>(i) / 4096.0F;
        // Three roundings of numbers near 1, and pow to 1 ulp: 4 * 2^-24.
        EXPECT_NEAR(double{developChannel(inFloat, linear)}, developChannel(inDouble, double{linear}), 2.4e-7);
    }
}

TEST(DevelopText, FloatDrawsTheSameNoise)
{
    texts::Develop<float> inFloat{};
    texts::Develop<double> inDouble{};
    for (int x = 0; x < 2000; ++x) {
        ASSERT_EQ(double{inFloat.uniformly(x, 7, 1, 0)}, inDouble.uniformly(x, 7, 1, 0));
        // The angle, up to 2 pi, is rounded to 2.4e-7, times the largest length of 5.8; log and sqrt add three roundings.
        ASSERT_NEAR(double{inFloat.normally(x, 7, 1)}, inDouble.normally(x, 7, 1), 4e-6);
    }
}

TEST(DevelopText, ChannelsDoNotMix)
{
    texts::Develop<double> text{};
    text.levels = 0.0;
    const Vec3d code = text.develop({0.5, -1.0, std::numeric_limits<double>::quiet_NaN()}, 0, 0, 1, 1);
    EXPECT_EQ(code, Vec3d(encodeSrgb(0.5), 0.0, 0.0));
}

TEST(DevelopText, StartsUnexposed)
{
    EXPECT_EQ(texts::Develop<float>{}.gain, 1.0F);
}

} // namespace
} // namespace reflectance
