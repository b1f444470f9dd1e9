// Errors about unreadable quantities suggest the unit or number that was probably meant.
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/units.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::string refusal(const std::string& text, const std::string& unit) {
  return messageOf<std::invalid_argument>([&] { log::parseQuantity(text, unit); });
}

TEST(UnitHints, NameTheUnitInItsRightSpelling) {
  EXPECT_EQ(refusal("3 kn", "N"), "unit 'kn' is unknown (did you mean 'kN'?)");
  EXPECT_EQ(refusal("3 KN/MM", "N/m"), "unit 'KN/MM' is unknown (did you mean 'kN/mm'?)");
  EXPECT_EQ(refusal("4 hz", "Hz"), "unit 'hz' is unknown (did you mean 'Hz'?)");
  EXPECT_EQ(refusal("4 degre", "rad"), "unit 'degre' is unknown (did you mean 'degree'?)");
}

// "Grad" is German for degrees. Read as giga-rad, 7 Grad would be 7e9 rad. The English "grad" is another unit, the gon.
TEST(Quantity, TakesGradForDegrees) {
  EXPECT_NEAR(log::parseQuantity("7 Grad", "rad"), 0.12217304763960307, 1e-15);
  EXPECT_EQ(refusal("7 grad", "rad"), "unit 'grad' is unknown (did you mean 'Grad'?)");
}

// Suggesting a unit of another dimension would lead to the next error.
TEST(UnitHints, AreOfTheDimensionThatIsWanted) {
  EXPECT_EQ(refusal("3 kn", "N/m"), "unit 'kn' is unknown");
  EXPECT_EQ(refusal("3 kN", "N/m"), "unit 'kN' cannot be converted to N/m");
  EXPECT_EQ(refusal("3 furlongg", "m"), "unit 'furlongg' is unknown");
}

TEST(UnitHints, WriteTheNumberWithADecimalPoint) {
  EXPECT_EQ(refusal("2,5 kN/mm", "N/m"), "a decimal comma (did you mean '2.5 kN/mm'?)");
  EXPECT_EQ(refusal("-0,25", "m"), "a decimal comma (did you mean '-0.25'?)");
  EXPECT_EQ(refusal("3,000 kN/m", "N/m"), "a comma (did you mean '3.000 kN/m' or '3000 kN/m'?)");
  EXPECT_EQ(refusal("3,000,000", "N/m"), "separators of thousands (did you mean '3000000'?)");
  EXPECT_EQ(refusal("3_000 N", "N"), "separators of thousands (did you mean '3000 N'?)");
  EXPECT_EQ(refusal("3'000'000 N/m", "N/m"), "separators of thousands (did you mean '3000000 N/m'?)");
  EXPECT_EQ(refusal("3 000 N", "N"), "separators of thousands (did you mean '3000 N'?)");
  EXPECT_EQ(refusal("3 2 N/m", "N/m"), "'2 N/m' after the number is not a unit");
  EXPECT_EQ(log::parseQuantity("2e-4 1/J", "1/J"), 2e-4);
}

// The text after the number must be one unit, although the library of units would also accept origins and factors.
TEST(Quantity, IsOneNumberAndOneUnit) {
  for (const char* text :
       {"3..4 kN/mm", "3 kN/mm +10 %", "3 kN/mm @ 20", "3 kN/mm 5", "3 N/m since 1970", "3 kN/mm - 1", "3 N/m from 2",
        "3 lg(re 1 mW)", "3 (N/m)", "3 N//m", "3 N/m/", "3 N/%", "1 2 N/m"}) {
    EXPECT_THROW(log::parseQuantity(text, "N/m"), std::invalid_argument) << text;
  }
  EXPECT_EQ(log::parseQuantity("3 kN/mm", "N/m"), 3e6);
  EXPECT_EQ(log::parseQuantity("3kg*s^-2", "N/m"), 3.0);
  EXPECT_EQ(log::parseQuantity("3 kg s-2", "N/m"), 3.0);
  EXPECT_EQ(log::parseQuantity("5 %", "1"), 0.05);
  EXPECT_NEAR(log::parseQuantity("20 degC", "K"), 293.15, 1e-12);
  EXPECT_EQ(log::parseQuantity("2 1/s", "1/s"), 2.0);
}

TEST(UnitOfQuantity, IsWhatStandsBehindTheNumber) {
  EXPECT_EQ(log::unitOfQuantity("3 kN/mm"), "kN/mm");
  EXPECT_EQ(log::unitOfQuantity(" 5.7deg "), "deg");
  EXPECT_EQ(log::unitOfQuantity("-3.0e6"), "");
  EXPECT_EQ(log::unitOfQuantity("5 %"), "%");
}

TEST(LogFormat, NamesTheQuantityThatWasMeant) {
  EXPECT_NE(messageOf<std::invalid_argument>([&] {
              log::makeLogFormat({"dispalcement=x"}, "", 0.0);
            }).find("(did you mean 'displacement'?)"),
            std::string::npos);
}

}  // namespace
}  // namespace rubber_suspension
