// `estimate --from-log` and `diagnose` vary the same parameters of every law.
#include "element/typical_elements.h"
#include "fit/force_model.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

using testing::IsSupersetOf;

log::Log recorded() {
  return logOf(
      "", 200, 5000000, [](int i) { return 1e-3 * std::sin(2.0 * element::kPi * 0.02 * i); },
      [](int /*i*/, double z) { return 3e3 * z; });
}

std::set<std::string> freeInEstimate(const std::vector<element::ElementDescription>& elements) {
  std::vector<element::ElementDescription> completed;
  for (const element::ElementDescription& element : elements) {
    completed.push_back(element::complete(element));
  }
  const std::vector<log::Log> logs = {recorded()};
  const fit::Compared none;
  const fit::ForceModel model(completed, logs, none, {});
  std::set<std::string> names;
  for (const auto* unknowns : {&model.nonlinear(), &model.linear()}) {
    for (const fit::Unknown& unknown : *unknowns) {
      names.insert(fmt::format("{}[{}].{}", elements[unknown.element].type, unknown.element, unknown.name));
    }
  }
  return names;
}

std::set<std::string> freeInDiagnosis(const std::vector<element::ElementDescription>& elements) {
  const fit::ModelParameters model(io::ComponentDescription("component", elements), fit::Level::elements);
  return {model.names().begin(), model.names().end()};
}

class FreeParameters : public testing::TestWithParam<element::ElementDescription> {};

INSTANTIATE_TEST_SUITE_P(AllLaws, FreeParameters, testing::ValuesIn(typicalElements()));

TEST_P(FreeParameters, AreTheSameInEstimateAndDiagnosis) {
  const std::vector<element::ElementDescription> elements = {spring(3e6), GetParam()};
  const std::set<std::string> names = freeInEstimate(elements);
  EXPECT_EQ(names, freeInDiagnosis(elements));
  EXPECT_THAT(names, IsSupersetOf({"spring[0].stiffness"}));
}

// Order and stiffness are varied. The limits of the frequency range are not.
TEST(FreeParameters, OfASpringpotAreStiffnessAndOrder) {
  const std::vector<element::ElementDescription> elements = {
      entry("springpot stiffness=1e6 order=0.3 low_frequency=0.1 high_frequency=50")};
  EXPECT_THAT(freeInEstimate(elements), ElementsAre("springpot[0].order", "springpot[0].stiffness"));
}

TEST(FreeParameters, OfCreepIsTheFallPerDecade) {
  const std::vector<element::ElementDescription> elements = {
      entry("creep stiffness_per_decade=2e5 shortest_time=0.05 longest_time=5")};
  EXPECT_THAT(freeInDiagnosis(elements), ElementsAre("creep[0].stiffness_per_decade"));
}

// A parameter with its default value is varied as well. The file states the parameter once its value has changed.
TEST(FreeParameters, IncludeDefaults) {
  const fit::ModelParameters model(io::ComponentDescription("component", {entry("stress_softening reduction=0.3")}),
                                   fit::Level::elements);
  ASSERT_THAT(model.names(), ElementsAre("stress_softening[0].reduction", "stress_softening[0].width"));
  EXPECT_EQ(model.apply(Eigen::Vector2d(0.0, 0.0)).elements().at(0).values.count("width"), 0U);
  EXPECT_DOUBLE_EQ(model.apply(Eigen::Vector2d(0.0, 0.1)).elements().at(0).value("width"), 0.5 * std::exp(0.1));
}

TEST(IsFree, KeepsEndsOfRangesListsChoicesAndReferences) {
  const element::ParameterInfo share{"share", "1", element::Role::shape, {0.0, 1.0, true, false}, "share", 1.0};
  EXPECT_FALSE(element::isFree(share, {1.0}));
  EXPECT_TRUE(element::isFree(share, {0.9}));
  element::ParameterInfo other{"other", "1", element::Role::scale, element::Range::any(), "other"};
  EXPECT_TRUE(element::isFree(other, {-2.0}));
  EXPECT_FALSE(element::isFree(other, {0.0}));
  for (const element::Role role : {element::Role::choice, element::Role::reference}) {
    other.role = role;
    EXPECT_FALSE(element::isFree(other, {2.0}));
  }
  const element::ParameterInfo list{"list", "N", element::Role::scale, element::Range::any(), "list", {}, true};
  EXPECT_FALSE(element::isFree(list, {1.0, 2.0}));
}

}  // namespace
}  // namespace rubber_suspension::test
