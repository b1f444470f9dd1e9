// Entries of component files: what is refused, with which words, and what is filled in.
#include "rubber_suspension/element/catalogue.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "element/typical_elements.h"
#include "support/message_of.h"

namespace rubber_suspension::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Property;
using testing::Throws;

struct Refused {
  const char* name;
  element::ElementDescription description;
  std::vector<std::string> words;
};

class RefusedEntry : public testing::TestWithParam<Refused> {};

INSTANTIATE_TEST_SUITE_P(
    Catalogue, RefusedEntry,
    testing::Values(
        Refused{"type", {"sprong", {}}, {"sprong", "spring", "iwan_table"}},
        Refused{
            "key", {"spring", {{"stifness", {1.0}}}}, {"spring.stifness", "unknown key (did you mean 'stiffness'?)"}},
        Refused{"missing", {"maxwell", {{"stiffness", {1.0}}}}, {"maxwell.break_frequency", "missing", "Hz"}},
        Refused{"range", {"spring", {{"stiffness", {-1.0}}}}, {"spring.stiffness", "-1", "greater than 0"}},
        Refused{"not_finite", {"spring", {{"stiffness", {INFINITY}}}}, {"spring.stiffness", "inf"}},
        Refused{"nan", {"dashpot", {{"damping", {NAN}}}}, {"dashpot.damping", "nan"}},
        Refused{"list", {"spring", {{"stiffness", {1.0, 2.0}}}}, {"spring.stiffness", "one number", "2"}},
        Refused{"empty", {"spring", {{"stiffness", {}}}}, {"spring.stiffness", "one number", "0"}},
        Refused{"sliders_fraction",
                {"iwan", {{"maximum_force", {1.0}}, {"displacement", {1.0}}, {"sliders", {3.5}}}},
                {"iwan.sliders", "3.5", "whole"}},
        Refused{"sliders_many",
                {"iwan", {{"maximum_force", {1.0}}, {"displacement", {1.0}}, {"sliders", {65.0}}}},
                {"iwan.sliders", "65", "[2, 64]"}},
        Refused{"table_lengths",
                {"iwan_table", {{"yield_displacement", {1.0, 2.0}}, {"stiffness", {1.0}}}},
                {"iwan_table.stiffness", "1 values for 2"}},
        Refused{"table_empty", {"iwan_table", {{"yield_displacement", {}}, {"stiffness", {}}}}, {"from 1 to 64"}},
        Refused{"table_value",
                {"iwan_table", {{"yield_displacement", {1.0, -2.0}}, {"stiffness", {1.0, 1.0}}}},
                {"iwan_table.yield_displacement", "-2"}},
        Refused{"spring_table_order",
                {"spring_table", {{"displacement", {0.0, 1.0, 0.5}}, {"force", {0.0, 1.0, 2.0}}}},
                {"spring_table.displacement", "0.5", "greater than 1"}},
        Refused{"springpot_range",
                {"springpot", {{"stiffness", {1.0}}, {"order", {0.5}}, {"low_frequency", {2000.0}}}},
                {"springpot.high_frequency", "1000", "2000"}},
        Refused{
            "springpot_order", {"springpot", {{"stiffness", {1.0}}, {"order", {1.0}}}}, {"springpot.order", "(0, 1)"}},
        Refused{"creep_times",
                {"creep", {{"stiffness_per_decade", {1.0}}, {"longest_time", {0.5}}}},
                {"creep.longest_time", "0.5"}},
        Refused{
            "side", {"bump_stop", {{"stiffness", {1.0}}, {"gap", {0.0}}, {"side", {0.3}}}}, {"bump_stop.side", "0.3"}},
        Refused{"mount_side",
                {"series_compliance", {{"stiffness", {1.0}}, {"side", {0.5}}}},
                {"series_compliance.side", "0.5", "-1"}},
        Refused{"contact_side",
                {"lift_off", {{"side", {0.5}}}},
                {"lift_off.side: 0.5 is out", "1 (F > 0 only) or -1 (F < 0 only)"}},
        Refused{"closing_force",
                {"series_compliance", {{"stiffness", {1.0}}, {"closing_force", {-2.0}}}},
                {"series_compliance.closing_force", "-2", "at least 0"}},
        Refused{"nothing_progressive", {"progressive_stiffness", {}}, {"progressive_stiffness.cubic", "quintic"}},
        Refused{"delay", {"time_delay", {{"delay", {1.0}}}}, {"time_delay.delay", "0.05"}}),
    [](const testing::TestParamInfo<Refused>& test) { return test.param.name; });

TEST_P(RefusedEntry, NamesWhatIsWrongAndWhatIsAccepted) {
  const std::string message = messageOf<std::invalid_argument>([&] { element::makeElement(GetParam().description); });
  for (const std::string& word : GetParam().words) {
    EXPECT_THAT(message, HasSubstr(word));
  }
  EXPECT_THAT(message, testing::Not(HasSubstr("\n")));
}

TEST(Catalogue, NamesAreUnique) {
  for (const element::ElementType& type : element::elementTypes()) {
    EXPECT_EQ(element::findElementType(type.name), &type) << type.name;
  }
  EXPECT_EQ(element::findElementType("nothing"), nullptr);
}

TEST(Catalogue, DefaultsAreFilledIn) {
  const element::ElementDescription full =
      element::complete({"iwan", {{"maximum_force", {1.0}}, {"displacement", {2.0}}}});
  EXPECT_EQ(full.value("sliders"), 16.0);
  EXPECT_EQ(full.value("displacement"), 2.0);
  EXPECT_EQ(element::complete(full).values, full.values);
}

TEST(Range, TellsWhatItAccepts) {
  EXPECT_EQ(element::describe(element::Range::positive()), "greater than 0");
  EXPECT_EQ(element::describe(element::Range::nonNegative()), "at least 0");
  EXPECT_EQ(element::describe(element::Range::closed(-1.0, 2.5)), "in [-1, 2.5]");
  EXPECT_EQ(element::describe(element::Range::open(0.0, 1.0)), "in (0, 1)");
  EXPECT_EQ(element::describe(element::Range::any()), "any finite number");
  EXPECT_FALSE(element::Range::any().contains(NAN));
  EXPECT_FALSE(element::Range::positive().contains(0.0));
  EXPECT_TRUE(element::Range::nonNegative().contains(0.0));
  EXPECT_FALSE(element::Range::nonNegative().contains(INFINITY));
}

}  // namespace
}  // namespace rubber_suspension::test
