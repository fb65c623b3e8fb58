// Formulas of the model texts, as they are set.
#include "app/explorer/ui/formula.h"
#include "core/reflectance/catalogue.h"

#include <gtest/gtest.h>

namespace reflectance::explorer {
namespace {

using enum PieceStyle;
using Pieces = std::vector<FormulaPiece>;

TEST(Formula, SetsSubscriptsExponentsAndTheScalarProduct)
{
    const Pieces expected = {{"k", Italic}, {"s", Subscript},    {" ", Upright}, {"I", Italic},  {" (", Upright},
                             {"R", Italic}, {"\u00B7", Upright}, {"V", Italic},  {")", Upright}, {"n", Superscript}};
    EXPECT_EQ(typeset("ks I (R.V)^n"), expected);
}

TEST(Formula, KeepsThePointOfNumbersAndWritesMinus)
{
    const Pieces expected = {{"1 \u2212 0.5 ", Upright}, {"A", Italic}};
    EXPECT_EQ(typeset("1 - 0.5 A"), expected);
}

TEST(Formula, TakesSymbolsFromTheParameters)
{
    Parameter r;
    r.name = "reflectance";
    r.symbol = std::string("r"); // GCC 12 sees an overflow in the assignment of one letter
    const Pieces expected = {{"r", Italic}, {" ", Upright}, {"I", Italic}};
    EXPECT_EQ(typeset("reflectance * I", std::vector{r}), expected);
}

TEST(Formula, WritesGreekAndFunctionNames)
{
    const Pieces expected = {
        {"max(0, ", Upright, false}, {"cos ", Upright}, {"\u03B8", Italic}, {"i", Subscript}, {")", Upright}};
    Pieces set = typeset("max(0, cos theta_i)");
    ASSERT_FALSE(set.empty());
    EXPECT_TRUE(set.front().mayBreakAfter) << "after the comma";
    EXPECT_EQ(set[set.size() - 3], expected[2]);
    EXPECT_EQ(set[set.size() - 2], expected[3]);
}

TEST(Formula, RaisesAGroup)
{
    const Pieces expected = {{"x", Italic}, {"n+1", Superscript}};
    EXPECT_EQ(typeset("x^(n+1)"), expected);
}

TEST(Formula, LosesNothingOfAnyModel)
{
    for (const Model& model : catalogue()) {
        const Pieces set = typeset(model.text.formula, model.text.parameters);
        EXPECT_FALSE(set.empty()) << model.id();
        for (const FormulaPiece& piece : set)
            EXPECT_TRUE(!piece.text.empty() && piece.text.find('^') == std::string::npos)
                << model.id() << ": " << piece.text;
    }
}

TEST(Formula, SurvivesWhatIsNoFormula)
{
    for (const char* text : {"", "^", "x^", "x^(", "x^(()", "_", "a__b", "...", "\xE2\x89", "((((", "^^^^"})
        EXPECT_NO_FATAL_FAILURE((void)typeset(text)) << text;
}

} // namespace
} // namespace reflectance::explorer
