// Names of points: none lies on another or leaves the field as long as there is room; legends of any length stay inside.
#include "core/chart/chart.h"
#include "core/chart/labels.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace reflectance {
namespace {

using testing::ElementsAre;

constexpr Box field{0.0, 0.0, 600.0, 400.0};

bool overlaps(const Box& a, const Box& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool isInside(const Box& box)
{
    return box.left >= field.left && box.top >= field.top && box.right <= field.right && box.bottom <= field.bottom;
}

int overlaps(const std::vector<PlacedLabel>& labels)
{
    int count = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = i + 1; j < labels.size(); ++j)
            count += overlaps(labels[i].box, labels[j].box) ? 1 : 0;
    return count;
}

TEST(Labels, ALoneNameStandsRightOfItsPoint)
{
    const auto labels = placedLabels({{100.0, 100.0, 60.0, 12.0}}, field);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_GT(labels[0].box.left, 100.0);
    EXPECT_FALSE(labels[0].far);
    EXPECT_NEAR(labels[0].box.right - labels[0].box.left, 60.0, 1e-12);
}

TEST(Labels, DoNotMeetWhereThereIsRoom)
{
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> x(0.0, 600.0), y(0.0, 400.0), width(20.0, 110.0);
    for (int chart = 0; chart < 50; ++chart) {
        std::vector<LabelWish> wishes;
        for (int i = 0; i < 14; ++i) // a chart's front, at most
            wishes.push_back({x(random), y(random), width(random), 12.0});
        const auto labels = placedLabels(wishes, field);
        EXPECT_EQ(overlaps(labels), 0) << chart;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_TRUE(isInside(labels[i].box)) << chart << ": " << i;
            for (const LabelWish& wish : wishes)
                EXPECT_FALSE(overlaps(labels[i].box, {wish.x - 1.0, wish.y - 1.0, wish.x + 1.0, wish.y + 1.0}));
        }
    }
}

TEST(Labels, OfPointsOnOneSpotAreLedToIt)
{
    const std::vector<LabelWish> wishes(8, {300.0, 200.0, 80.0, 12.0});
    const auto labels = placedLabels(wishes, field);
    EXPECT_EQ(overlaps(labels), 0);
    EXPECT_TRUE(labels.back().far);
    const LabelEnd end = endTowards(labels.back().box, 300.0, 200.0);
    EXPECT_LT(std::hypot(end.x - 300.0, end.y - 200.0), 80.0) << "but not far away";
}

TEST(Labels, TheTestSeesNamesThatWereNotNudged) // planted
{
    std::vector<PlacedLabel> naive;
    for (int i = 0; i < 8; ++i)
        naive.push_back({{306.0, 194.0, 386.0, 206.0}, false});
    EXPECT_GT(overlaps(naive), 0);
}

TEST(Labels, WithoutRoomStayInTheFieldAndDoNotFail)
{
    EXPECT_EQ(placedLabels({}, field).size(), 0U);
    const auto crowded = placedLabels(std::vector<LabelWish>(300, {10.0, 10.0, 100.0, 12.0}), field);
    for (const PlacedLabel& label : crowded)
        EXPECT_TRUE(isInside(label.box));
    EXPECT_EQ(placedLabels({{5.0, 5.0, 900.0, 12.0}}, field).size(), 1U) << "a name wider than the field";
}

TEST(TextLines, PartAtBlanks)
{
    EXPECT_THAT(textLines("one two three", 10, textWidth("one two", 10)), ElementsAre("one two", "three"));
    EXPECT_THAT(textLines("one two", 10, 1000.0), ElementsAre("one two"));
    EXPECT_THAT(textLines("unbreakable", 10, 1.0), ElementsAre("unbreakable"));
    EXPECT_THAT(textLines("a b", 10, 1.0), ElementsAre("a", "b"));
    EXPECT_THAT(textLines("", 10, 10.0), ElementsAre());
}

TEST(Legend, OfALongNameStaysInThePicture)
{
    Chart chart{"", {"x", 0.0, 1.0}, {"y", 0.0, 1.0}, {}, {}};
    chart.series.push_back({"traced with interreflection, facets of Lambert at thirty degrees", 0, {0, 1}, {0, 1}});
    const std::string svg = svgOf(chart, 760, 460);
    EXPECT_EQ(svg.find("traced with interreflection, facets of Lambert at"), std::string::npos) << "in one line";
    EXPECT_NE(svg.find("degrees</text>"), std::string::npos);
}

} // namespace
} // namespace reflectance
