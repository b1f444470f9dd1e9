// Entries of component files: defaults, and refusals with their messages.
#include "rubber_suspension/element/catalogue.h"

#include "element/largest_number.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

struct Refused {
  const char* name;
  const char* entry;
  std::vector<std::string> words;
};

class RefusedEntry : public testing::TestWithParam<Refused> {};

const std::vector<Refused> kRefused = {
    {"type", "sprong", {"sprong", "spring", "iwan_table"}},
    {"key", "spring stifness=1", {"spring.stifness", "unknown key (did you mean 'stiffness'?)"}},
    {"missing", "maxwell stiffness=1", {"maxwell.break_frequency", "missing", "Hz"}},
    {"range", "spring stiffness=-1", {"spring.stiffness", "-1", "greater than 0"}},
    {"not_finite", "spring stiffness=inf", {"spring.stiffness", "inf"}},
    {"nan", "dashpot damping=nan", {"dashpot.damping", "nan"}},
    {"list", "spring stiffness=1,2", {"spring.stiffness", "one number", "2"}},
    {"empty", "spring stiffness=", {"spring.stiffness", "one number", "0"}},
    {"sliders_fraction", "iwan maximum_force=1 displacement=1 sliders=3.5", {"iwan.sliders", "3.5", "whole"}},
    {"sliders_many", "iwan maximum_force=1 displacement=1 sliders=65", {"iwan.sliders", "65", "[2, 64]"}},
    {"table_lengths", "iwan_table yield_displacement=1,2 stiffness=1", {"iwan_table.stiffness", "1 values for 2"}},
    {"table_empty", "iwan_table yield_displacement= stiffness=", {"with 1 to 64 values"}},
    {"table_value", "iwan_table yield_displacement=1,-2 stiffness=1,1", {"iwan_table.yield_displacement", "-2"}},
    {"spring_table_order",
     "spring_table displacement=0,1,0.5 force=0,1,2",
     {"spring_table.displacement", "0.5", "greater than 1"}},
    {"spring_table_repeats", "spring_table displacement=0,0 force=0,1", {"spring_table.displacement"}},
    {"spring_table_falls", "spring_table displacement=0,1 force=0,-1", {"spring_table.force", "-1"}},
    {"spring_table_preload", "spring_table displacement=0,1 force=1,2", {"spring_table.force", "at displacement 0"}},
    {"spring_table_of_one_point", "spring_table displacement=0 force=0", {"spring_table"}},
    {"spring_table_of_none", "spring_table displacement= force=", {"spring_table"}},
    {"spring_table_lengths", "spring_table displacement=0,1 force=0", {"spring_table"}},
    {"springpot_range",
     "springpot stiffness=1 order=0.5 low_frequency=2000",
     {"springpot.high_frequency", "1000", "2000"}},
    {"springpot_order", "springpot stiffness=1 order=1", {"springpot.order", "(0, 1)"}},
    {"creep_times", "creep stiffness_per_decade=1 longest_time=0.5", {"creep.longest_time", "0.5"}},
    {"stop_side", "bump_stop stiffness=1 gap=0 side=0.3", {"bump_stop.side", "0.3"}},
    {"mount_side", "series_compliance stiffness=1 side=0.5", {"series_compliance.side", "0.5", "-1"}},
    {"contact_side", "lift_off side=0.5", {"lift_off.side: 0.5 is out", "1 (F > 0 only) or -1 (F < 0 only)"}},
    {"first_loading_side", "first_loading stiffness=1e6 yield_share=0.2 side=0.5", {"first_loading.side", "0.5"}},
    {"first_loading_range", "first_loading stiffness=1e6 yield_share=0.2 side=2", {"first_loading.side", "2"}},
    {"softening_side", "stress_softening reduction=0.3 side=0.5", {"stress_softening.side", "0.5"}},
    {"softening_exponent_without_reach",
     "stress_softening reduction=0.3 reach_exponent=1",
     {"stress_softening.full_reach", "if a reach_exponent is given"}},
    {"closing_force",
     "series_compliance stiffness=1 closing_force=-2",
     {"series_compliance.closing_force", "-2", "at least 0"}},
    {"nothing_progressive", "progressive_stiffness", {"progressive_stiffness.cubic", "quintic"}},
    {"cubic_of_0", "progressive_stiffness cubic=0", {"progressive_stiffness.cubic", "quintic"}},
    {"negative_cubic", "progressive_stiffness cubic=-1", {"progressive_stiffness.cubic", "-1"}},
    {"progressive_exponential_without_scale",
     "progressive_stiffness exponential=1e5",
     {"progressive_stiffness.exponential_scale", "if an exponential is given"}},
    {"asymmetric_exponential_without_scale",
     "asymmetric_stiffness exponential=1e5",
     {"asymmetric_stiffness.exponential_scale", "if an exponential is given"}},
    {"nothing_radial", "radial_stiffness alone=0.5", {"radial_stiffness.cubic"}},
    {"bouc_wen_that_makes_energy", "bouc_wen stiffness=2e6 beta=600 gamma=-601", {"bouc_wen.gamma", "-601"}},
    {"track_of_nothing", "inertia_track", {"inertia_track"}},
    {"track_without_stiffness", "inertia_track mass=1 damping=1", {"inertia_track"}},
    {"track_of_both_sets", "inertia_track mass=1 damping=1 stiffness=1 compliance=1", {"inertia_track"}},
    {"track_with_a_number_of_its_fluid",
     "inertia_track mass=1 damping=1 stiffness=1 quadratic_resistance=1",
     {"inertia_track"}},
    {"growth_beside_several_points",
     "maxwell_along_curve stiffness=3e6 displacement=-2e-3,2e-3 break_frequency=1e-6 growth=3 side=0",
     {"maxwell_along_curve.growth: is 3 with 2 displacements and 1 stiffness values; accepted: one displacement "
      "greater than 0 "
      "and one stiffness, or no growth"}},
    {"delay", "time_delay delay=1", {"time_delay.delay", "0.05"}}};

INSTANTIATE_TEST_SUITE_P(Catalogue, RefusedEntry, testing::ValuesIn(kRefused),
                         [](const auto& test) { return test.param.name; });

TEST_P(RefusedEntry, NamesWhatIsWrongAndWhatIsAccepted) {
  const std::string message = messageOf<std::invalid_argument>([&] { element::makeElement(entry(GetParam().entry)); });
  for (const std::string& word : GetParam().words) {
    EXPECT_THAT(message, HasSubstr(word));
  }
  EXPECT_THAT(message, testing::Not(HasSubstr("\n")));
}

TEST(Catalogue, AcceptsWhatIsAtTheLimitOfARule) {
  for (const char* text : {"progressive_stiffness quintic=1", "bouc_wen stiffness=2e6 beta=600 gamma=-600",
                           "progressive_stiffness exponential=1e5 exponential_scale=1e-3"}) {
    EXPECT_NO_THROW(element::makeElement(entry(text))) << text;
  }
}

TEST(Catalogue, NamesAreUnique) {
  for (const element::ElementType& type : element::elementTypes()) {
    EXPECT_EQ(element::findElementType(type.name), &type) << type.name;
  }
  EXPECT_EQ(element::findElementType("nothing"), nullptr);
}

TEST(Catalogue, DefaultsAreFilledIn) {
  const element::ElementDescription full = element::complete(entry("iwan maximum_force=1 displacement=2"));
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
  // Values below 1e-100 are too small for products. A signal, which may have either sign, has no such limit.
  EXPECT_FALSE(element::Range::nonNegative().contains(5e-324));
  EXPECT_FALSE(element::Range::closed(0.0, 1.0).contains(1e-101));
  EXPECT_TRUE(element::Range::positive().contains(1e-100));
  EXPECT_TRUE(element::Range::any().contains(5e-324));
  EXPECT_EQ(element::acceptedFor(5e-324, element::Range::positive()), "greater than 0, at least 1e-100");
}

}  // namespace
}  // namespace rubber_suspension::test
