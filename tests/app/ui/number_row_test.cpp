// The slider under hand: drag, double-click, typing; what is legal and what is refused.
#include "app/explorer/ui/number_row.h"
#include "tests/app/ui/stage.h"

#include <gmock/gmock.h>

namespace reflectance::explorer {
namespace {

class NumberRowTest : public testing::Test {
protected:
    NumberRowTest()
    {
        row.name = "ks";
        row.symbol = "k_s";
        row.label = "Specular strength";
        row.about = "Height of the highlight.";
        row.legalMin = 0.0;
        row.initial = 0.25;
    }

    Stage::Draw draw()
    {
        return [this] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({300, 60});
            ImGui::Begin("row", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            changes += numberRow(row, value, message) ? 1 : 0;
            low = ImGui::GetItemRectMin();
            high = ImGui::GetItemRectMax();
            ImGui::End();
        };
    }

    ImVec2 at(float share) { return {low.x + share * (high.x - low.x), (low.y + high.y) / 2}; }

    /// Ctrl+click, the text, Enter.
    void typeIn(const std::string& text)
    {
        stage.frame(draw());
        ImGui::GetIO().KeyCtrl = true;
        stage.click(at(0.5F), draw());
        ImGui::GetIO().KeyCtrl = false;
        stage.type(text, draw());
        stage.press(ImGuiKey_Enter, draw());
    }

    Stage stage{300, 60};
    NumberRow row;
    double value = 0.123456789;
    std::optional<Message> message;
    int changes = 0;
    ImVec2 low, high;
};

TEST_F(NumberRowTest, KeepsAnUntouchedValueToTheLastBit)
{
    for (int i = 0; i < 3; ++i)
        stage.frame(draw());
    EXPECT_EQ(value, 0.123456789);
    EXPECT_EQ(changes, 0);
}

TEST_F(NumberRowTest, FollowsTheMouse)
{
    stage.frame(draw());
    stage.click(at(0.75F), draw());
    // The slider is some 150 pixels long and shows three decimals.
    EXPECT_NEAR(value, 0.75, 0.02);
    EXPECT_GT(changes, 0);
}

TEST_F(NumberRowTest, GoesBackToTheDefaultOnDoubleClickAndStaysThere)
{
    stage.frame(draw());
    stage.doubleClick(at(0.9F), draw());
    EXPECT_EQ(value, 0.25);
    // Held still after the second press, the mouse must not drag the value away again.
    stage.moveTo(at(0.9F));
    stage.frame(draw());
    EXPECT_EQ(value, 0.25);
}

TEST_F(NumberRowTest, HoldsTheDefaultWhileTheSecondPressLasts)
{
    stage.frame(draw());
    stage.click(at(0.9F), draw());
    stage.hold(true);
    for (int i = 0; i < 4; ++i)
        stage.frame(draw());
    EXPECT_EQ(value, 0.25);
}

TEST_F(NumberRowTest, TakesTypedValues)
{
    typeIn("0.123456");
    EXPECT_EQ(value, 0.123456) << "typed digits are kept, also those that the slider does not show";
    EXPECT_FALSE(message);
}

TEST_F(NumberRowTest, TakesTypedValuesBeyondTheSliderWhereTheyAreLegal)
{
    typeIn("7.5");
    EXPECT_EQ(value, 7.5);
    EXPECT_FALSE(message);
}

TEST_F(NumberRowTest, RefusesWhatIsNotLegalAndSaysTheRange)
{
    typeIn("-0.5");
    EXPECT_EQ(value, 0.123456789);
    ASSERT_TRUE(message);
    EXPECT_TRUE(message->isError);
    EXPECT_THAT(message->text, testing::AllOf(testing::HasSubstr("Specular strength"), testing::HasSubstr("-0.5"),
                                              testing::HasSubstr("0 to \u221E")));
}

TEST_F(NumberRowTest, RefusesNotANumber)
{
    typeIn("nan");
    EXPECT_EQ(value, 0.123456789);
}

TEST_F(NumberRowTest, CoversALogarithmicRangeEvenly)
{
    row.sliderMin = 1.0;
    row.sliderMax = 10000.0;
    row.logarithmic = true;
    value = 40.0;
    stage.frame(draw());
    stage.click(at(0.5F), draw());
    EXPECT_NEAR(value, 100.0, 10.0) << "the middle of 1 .. 10000";
}

TEST_F(NumberRowTest, ShowsATooltipOnlyAfterARest)
{
    stage.frame(draw());
    stage.moveTo(at(0.5F));
    stage.frame(draw());
    EXPECT_FALSE(Stage::showsTooltip());
    for (int i = 0; i < 12; ++i) // 0.6 s
        stage.frame(draw());
    EXPECT_TRUE(Stage::showsTooltip());
}

} // namespace
} // namespace reflectance::explorer
