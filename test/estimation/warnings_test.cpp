// Unusual specifications cause warnings in the units of the user. Usual specifications cause none.
#include "rubber_suspension/estimation/notes.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

estimation::Specification stiffnesses(double k_st, double k_n, double k_max) {
  estimation::Specification specification;
  specification.set("static_stiffness", k_st);
  specification.set("dynamic_stiffness", k_n);
  specification.set("maximum_stiffness", k_max);
  return specification;
}

TEST(SpecificationWarnings, OfStiffnessesThatNoMeasurementTellsApart) {
  estimation::Specification specification = stiffnesses(10e6, 12.49e6, 12.5e6);
  specification.writeIn({{"maximum_stiffness", {"kN/mm", 1e6}}});
  EXPECT_THAT(estimation::specificationWarnings(specification),
              ElementsAre(HasSubstr("maximum_stiffness: 12.5 kN/mm is only 0.08 % above dynamic_stiffness: "
                                    "1.249e+07 N/m")));
  EXPECT_THAT(estimation::specificationWarnings(stiffnesses(3e6, 3.01e6, 4e6)),
              ElementsAre(HasSubstr("dynamic_stiffness: 3.01e+06 N/m is only 0.33 % above static_stiffness")));
}

TEST(SpecificationWarnings, OfKilonewtonsPerMillimetreWithoutTheirUnit) {
  EXPECT_THAT(estimation::specificationWarnings(stiffnesses(10.0, 12.0, 13.0)),
              ElementsAre(HasSubstr("static_stiffness: 10 N/m is softer than any suspension component; did you mean "
                                    "'10 kN/mm'?")));
}

TEST(SpecificationWarnings, OfNothingInWhatIsUsual) {
  EXPECT_THAT(estimation::specificationWarnings(stiffnesses(3e6, 4.2e6, 4.9e6)), IsEmpty());
  EXPECT_THAT(estimation::specificationWarnings(stiffnesses(50e3, 60e3, 65e3)), IsEmpty());  // a soft engine mount
  EXPECT_THAT(estimation::specificationWarnings({}), IsEmpty());
}

}  // namespace
}  // namespace rubber_suspension
