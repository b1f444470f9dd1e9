// Specifications of a whole component: reference values, and targets that are met with any added elements.
#include "rubber_suspension/estimation/whole.h"

#include <rapidcheck/gtest.h>

#include "estimation/values.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

// Every run draws the same cases, unless the environment variable RC_PARAMS is set.
const bool kSeeded = setenv("RC_PARAMS", "seed=20150817 max_success=50", 0) == 0;

constexpr double kDegree = element::kPi / 180.0;

Values fiveInputs(double dynamic_stiffness, double amplitude) {
  return {{"static_stiffness", 3e6},  {"dynamic_stiffness", dynamic_stiffness},
          {"nominal_frequency", 4.0}, {"maximum_stiffness", 4.9e6},
          {"high_frequency", 25.0},   {"nominal_amplitude", amplitude}};
}

const Entries kFriction = {friction(6e3, 2.2e-3)};

Entries wholeOf(estimation::Model model, const estimation::Specification& base, const Entries& add) {
  Entries all = estimation::estimate(model, base);
  all.insert(all.end(), add.begin(), add.end());
  return all;
}

response::Characteristics at(const Entries& elements, double frequency, double amplitude, double mean = 0.0) {
  response::LoopOptions options;
  options.mean = mean;
  return response::characteristicsAt(component::Component(elements), frequency, amplitude, options).characteristics;
}

std::string refusal(estimation::Model model, const estimation::Specification& specification, const Entries& add) {
  return messageOf<std::invalid_argument>([&] { estimation::resolve(model, specification, add); });
}

TEST(WholeComponent, OfTooLargeARatioIsRefusedAsABaseIs) {
  const std::string text = refusal(estimation::Model::multi_maxwell,
                                   specificationOf(with(fiveInputs(4.2e6, 2e-3), "static_stiffness", 0.3e6)), {});
  EXPECT_THAT(text, testing::HasSubstr("dynamic_stiffness: 4.2e+06 N/m is more than 10 times static_stiffness"));
  EXPECT_THAT(text, testing::HasSubstr("accepted: "));
}

// An independent program computed these values (docs/estimation.md). Tolerances are half a unit of the last digit.
TEST(WholeComponent, OfFiveInputsWithFriction) {
  const struct {
    double amplitude, alpha, loss_angle;
  } rows[] = {{2e-3, 0.506837, 10.8247}, {1e-3, 0.222246, 10.3648}};
  for (const auto& row : rows) {
    const auto resolved = estimation::resolve(estimation::Model::multi_maxwell,
                                              specificationOf(fiveInputs(5e6, row.amplitude)), kFriction);
    const Entries elements = estimation::estimate(estimation::Model::multi_maxwell, resolved.specification);
    EXPECT_NEAR(elements[1].value("stiffness") / elements[2].value("stiffness"), row.alpha, 5e-7);
    const auto whole =
        at(wholeOf(estimation::Model::multi_maxwell, resolved.specification, kFriction), 4.0, row.amplitude);
    EXPECT_NEAR(whole.stiffness, 5e6, 5e-3);
    EXPECT_NEAR(whole.loss_angle / kDegree, row.loss_angle, 5e-5);
    EXPECT_THAT(resolved.notes, IsEmpty());
  }
  const auto resolved =
      estimation::resolve(estimation::Model::multi_maxwell, specificationOf(fiveInputs(5e6, 2e-3)), kFriction);
  const Entries elements = estimation::estimate(estimation::Model::multi_maxwell, resolved.specification);
  const double stiffness[] = {0.06397212, 0.12621836, 0.24903154, 0.49134458, 0.96943340};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(elements[i + 1].value("stiffness"), 1e6 * stiffness[i], 0.1);
  }
}

// A specification of the base model ignores friction, so the whole component differs much from its numbers.
TEST(WholeComponent, OfABaseIsWhatComesOut) {
  for (const auto& [amplitude, stiffness, angle] :
       {std::tuple(2e-3, 5.38137e6, 9.0587), std::tuple(1e-3, 5.78245e6, 7.9395)}) {
    const auto specification = specificationOf(fiveInputs(4.2e6, amplitude), estimation::Describes::base);
    const auto resolved = estimation::resolve(estimation::Model::multi_maxwell, specification, kFriction);
    EXPECT_EQ(resolved.specification.values(), specification.values());
    const auto whole = at(wholeOf(estimation::Model::multi_maxwell, specification, kFriction), 4.0, amplitude);
    EXPECT_NEAR(whole.stiffness, stiffness, 5.0);
    EXPECT_NEAR(whole.loss_angle / kDegree, angle, 5e-5);
  }
}

TEST(WholeComponent, WithoutASolutionNamesWhatItCanHave) {
  const auto specification = specificationOf(fiveInputs(4.2e6, 2e-3));
  const std::string message = refusal(estimation::Model::multi_maxwell, specification, kFriction);
  EXPECT_THAT(message, HasSubstr("dynamic_stiffness: 4.2e+06 N/m cannot be reached by the whole component"));
  EXPECT_THAT(message, HasSubstr("4.33623e+06 to 6.08374e+06 N/m"));
  EXPECT_THAT(message, HasSubstr("dynamic_stiffness in (4.33623e+06, 6.08374e+06) N/m"));
  EXPECT_THAT(message, HasSubstr("nearest: specification: {"));
  EXPECT_THAT(refusal(estimation::Model::multi_maxwell, specificationOf(fiveInputs(4.2e6, 1e-3)), kFriction),
              HasSubstr("4.73595e+06 to 6.48645e+06 N/m"));
}

TEST(WholeComponent, NeedsAnAmplitudeWhereItIsNonlinear) {
  auto values = fiveInputs(5e6, 2e-3);
  values.erase("nominal_amplitude");
  EXPECT_THAT(refusal(estimation::Model::multi_maxwell, specificationOf(values), kFriction),
              HasSubstr("nominal_amplitude is missing"));
  values["dynamic_stiffness"] = 4.2e6;
  EXPECT_EQ(refusal(estimation::Model::multi_maxwell, specificationOf(values), {maxwell(2e5, 1.0)}), "");
}

// Added springs and Maxwell elements are included in the static and in the maximum stiffness.
TEST(WholeComponent, SharesItsStiffnessesWithWhatIsAdded) {
  const Entries add = {spring(5e5), maxwell(2e5, 1.0)};
  const auto base = estimation::resolve(estimation::Model::multi_maxwell, specificationOf(fiveInputs(4.2e6, 2e-3)), add)
                        .specification;
  EXPECT_NEAR(base.at("static_stiffness"), 2.5e6, 1e-3);
  EXPECT_NEAR(base.at("maximum_stiffness"), 4.2e6, 1e-3);
  EXPECT_NEAR(at(wholeOf(estimation::Model::multi_maxwell, base, add), 4.0, 2e-3).stiffness, 4.2e6, 1e-2);
  EXPECT_THAT(
      refusal(estimation::Model::multi_maxwell, specificationOf(fiveInputs(4.2e6, 2e-3)), {spring(3.1e6)}),
      HasSubstr("static_stiffness: 3e+06 N/m is not above 3.1e+06 N/m, the stiffness of the elements under add:"));
}

TEST(WholeComponent, LeavesOutWhatNeverSettles) {
  const Entries add = {friction(6e3, 2.2e-3), entry("force_drift rate=5"),
                       entry("self_heating energy_sensitivity=1e-3 time_constant=20"),
                       entry("stress_softening reduction=0.3")};
  const auto specification = specificationOf(fiveInputs(5e6, 2e-3));
  const auto resolved = estimation::resolve(estimation::Model::multi_maxwell, specification, add);
  EXPECT_THAT(resolved.notes, ElementsAre(HasSubstr("force_drift, self_heating, stress_softening")));
  EXPECT_EQ(resolved.specification.values(),
            estimation::resolve(estimation::Model::multi_maxwell, specification, kFriction).specification.values());
}

/// A specification of the base model that has a solution.
struct Case {
  estimation::Model model;
  std::map<std::string, double> base;
};

double between(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0; }

std::map<std::string, double> anyBase(estimation::Model model) {
  std::map<std::string, double> base = {{"static_stiffness", 3e6},
                                        {"dynamic_stiffness", 1e6 * between(3.6, 4.4)},
                                        {"nominal_frequency", between(2.0, 8.0)},
                                        {"nominal_amplitude", 1e-3 * between(0.5, 3.0)}};
  using estimation::Model;
  if (model == Model::multi_maxwell) {
    base["maximum_stiffness"] = base["dynamic_stiffness"] + 1e6 * between(0.3, 1.0);
    base["high_frequency"] = base["nominal_frequency"] * between(5.0, 10.0);
  } else if (model == Model::maxwell && *rc::gen::arbitrary<bool>()) {
    base["maximum_stiffness"] = base["dynamic_stiffness"] + 1e6 * between(0.3, 1.0);
  } else {
    base["loss_angle"] = kDegree * between(2.0, 6.0);
  }
  if (model == Model::maxwell_dashpot) {
    base["break_frequency"] = 0.3;
  }
  if (model == Model::berg) {
    base["break_frequency"] = between(1.0, 3.0);
  }
  if (model == Model::kelvin_voigt) {
    base.erase("static_stiffness");
  }
  return base;
}

/// Draws elements that have a settled loop. The last two types are in series, so forces do not add up.
Entries anyAdded(estimation::Model model) {
  const Entries all = {friction(2e3, 5e-4),
                       entry("iwan maximum_force=1e3 displacement=3e-4 sliders=8"),
                       entry("bouc_wen stiffness=1e6 beta=900 gamma=300"),
                       maxwell(3e5, 2.0),
                       spring(4e5),
                       dashpot(2e3),
                       entry("progressive_stiffness cubic=5e10"),
                       entry("bump_stop stiffness=5e6 gap=1e-3"),
                       entry("inertia_track mass=100 damping=3e3 stiffness=4e5"),
                       entry("free_play gap=5e-5"),
                       entry("series_compliance stiffness=6e7")};
  // Behind a series compliance, slow elements need hundreds of cycles to settle.
  const int end = static_cast<int>(all.size()) - (model == estimation::Model::multi_maxwell ? 2 : 0);
  Entries added;
  for (const int i : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, end))) {
    if (added.size() < 3) {
      added.push_back(all[static_cast<std::size_t>(i)]);
    }
  }
  return added;
}

double addedAtRest(const Entries& added) {
  double sum = 0.0;
  for (const element::ElementDescription& entry : added) {
    sum += entry.type == "spring" ? entry.value("stiffness") : 0.0;
  }
  return sum;
}

double addedLimit(const Entries& added) {
  double sum = 0.0;
  for (const element::ElementDescription& entry : added) {
    const bool counts = entry.type == "spring" || entry.type == "maxwell" || entry.type == "inertia_track";
    sum += counts ? entry.value("stiffness") : 0.0;
  }
  return sum;
}

// The specified values are those of a base model with any added elements. So a solution exists and must be found.
RC_GTEST_PROP(WholeComponent, MeetsWhatIsSpecifiedForAnyAdd, ()) {
  using estimation::Model;
  const Model model = *rc::gen::element(Model::kelvin_voigt, Model::maxwell, Model::maxwell_dashpot, Model::friction,
                                        Model::friction_dashpot, Model::berg, Model::multi_maxwell);
  const std::map<std::string, double> base = anyBase(model);
  const Entries added = anyAdded(model);
  const auto base_specification = specificationOf(base, estimation::Describes::base);
  try {
    estimation::estimate(model, base_specification);
  } catch (const std::invalid_argument&) {
    RC_DISCARD("no base");
  }
  const double frequency = base.at("nominal_frequency");
  const double amplitude = base.at("nominal_amplitude");
  const auto target = at(wholeOf(model, base_specification, added), frequency, amplitude);
  std::map<std::string, double> whole = base;
  whole["dynamic_stiffness"] = target.stiffness;
  if (base.count("loss_angle") != 0) {
    whole["loss_angle"] = target.loss_angle;
  }
  if (model != Model::kelvin_voigt) {
    whole["static_stiffness"] += addedAtRest(added);
  }
  if (base.count("maximum_stiffness") != 0) {
    whole["maximum_stiffness"] += addedLimit(added);
  }
  const auto found = estimation::resolve(model, specificationOf(whole), added).specification;
  const auto reached = at(wholeOf(model, found, added), frequency, amplitude);
  RC_ASSERT(std::abs(reached.stiffness / target.stiffness - 1.0) <= 1e-6);
  if (base.count("loss_angle") != 0) {
    RC_ASSERT(std::abs(reached.loss_angle - target.loss_angle) <= 1e-6);
  }
}

// One Maxwell element (closed form) and five elements have the specified 3.1 kN/mm at 40 Hz.
TEST(HighFrequencyStiffness, IsThatAtItsFrequency) {
  const std::map<std::string, double> values = {{"static_stiffness", 2e6},
                                                {"dynamic_stiffness", 2.5e6},
                                                {"nominal_frequency", 4.0},
                                                {"high_frequency_stiffness", 3.1e6},
                                                {"high_frequency", 40.0}};
  for (const auto model : {estimation::Model::maxwell, estimation::Model::multi_maxwell}) {
    const Entries elements = estimation::estimate(model, specificationOf(values, estimation::Describes::unsaid));
    EXPECT_NEAR(at(elements, 40.0, 1e-3).stiffness, 3.1e6, 3.1e-3) << estimation::toString(model);
    EXPECT_NEAR(at(elements, 4.0, 1e-3).stiffness, 2.5e6, 3.1e-3) << estimation::toString(model);
  }
  auto steep = values;
  steep["high_frequency_stiffness"] = 19e6;
  steep["high_frequency"] = 5.0;
  EXPECT_THROW(estimation::estimate(estimation::Model::maxwell, specificationOf(steep, estimation::Describes::base)),
               std::invalid_argument);
}

TEST(HighFrequencyStiffness, OfTheWholeComponent) {
  auto values = fiveInputs(5e6, 2e-3);
  values.erase("maximum_stiffness");
  values["high_frequency_stiffness"] = 5.6e6;
  for (const Entries& added : {kFriction, Entries{kFriction[0], entry("progressive_stiffness cubic=5e10")}}) {
    const auto base =
        estimation::resolve(estimation::Model::multi_maxwell, specificationOf(values), added).specification;
    const Entries whole = wholeOf(estimation::Model::multi_maxwell, base, added);
    EXPECT_NEAR(at(whole, 4.0, 2e-3).stiffness, 5e6, 5.0);
    EXPECT_NEAR(at(whole, 25.0, 2e-3).stiffness, 5.6e6, 5.6);
  }
}

estimation::Specification pointsOf(const Entries& truth, const std::vector<std::pair<double, double>>& places) {
  estimation::Specification specification;
  std::vector<estimation::SpecifiedPoint> points;
  for (const auto& [frequency, amplitude] : places) {
    const auto found = at(truth, frequency, amplitude);
    points.push_back({frequency, amplitude, found.stiffness, found.loss_angle, 1.0});
  }
  specification.setPoints(points);
  return specification;
}

// Every model can be fitted to points that the same model generated.
TEST(Points, OfAModelAreMet) {
  using estimation::Model;
  const std::vector<std::pair<double, double>> places = {{0.5, 1e-3}, {4.0, 2e-3}, {4.0, 5e-4}, {20.0, 2e-4}};
  for (const Model model : {Model::kelvin_voigt, Model::maxwell, Model::maxwell_dashpot, Model::friction,
                            Model::friction_dashpot, Model::berg, Model::multi_maxwell}) {
    std::map<std::string, double> truth = fiveInputs(4.2e6, 2e-3);
    if (model != Model::multi_maxwell) {
      truth = {{"static_stiffness", 3e6},
               {"dynamic_stiffness", 4.2e6},
               {"nominal_frequency", 4.0},
               {"nominal_amplitude", 2e-3},
               {"loss_angle", 6.0 * kDegree}};
    }
    if (model == Model::maxwell_dashpot || model == Model::berg) {
      truth["break_frequency"] = 0.9;
    }
    const Entries elements = estimation::estimate(model, specificationOf(truth, estimation::Describes::base));
    auto specification = pointsOf(elements, places);
    if (model == Model::multi_maxwell) {
      specification.set("high_frequency", 25.0);
      specification.set("low_frequency", 5.0 * 25.0 / 1e4);
    }
    const auto resolved = estimation::resolve(model, specification, {});
    ASSERT_EQ(resolved.points.size(), places.size());
    for (const estimation::PointMisfit& misfit : resolved.points) {
      EXPECT_NEAR(misfit.stiffness / *misfit.point.stiffness, 1.0, 1e-5) << estimation::toString(model);
      EXPECT_NEAR(misfit.loss_angle, *misfit.point.loss_angle, 1e-5) << estimation::toString(model);
    }
    // The numbers of the resolved specification give the same elements.
    const Entries again = estimation::estimate(model, resolved.specification);
    for (const auto& [frequency, amplitude] : places) {
      EXPECT_NEAR(at(again, frequency, amplitude).stiffness / at(elements, frequency, amplitude).stiffness, 1.0, 1e-5)
          << estimation::toString(model);
    }
  }
}

// If two points contradict each other, the point with more weight is met better, and the misfit is reported.
TEST(Points, AreWeighted) {
  estimation::Specification specification;
  specification.setPoints({{4.0, 0.0, 4e6, 0.1, 100.0}, {4.0, 0.0, 5e6, 0.1, 1.0}});
  const auto resolved = estimation::resolve(estimation::Model::kelvin_voigt, specification, {});
  // The logarithm of the stiffness is the weighted mean of the logarithms.
  EXPECT_NEAR(resolved.points[0].stiffness, std::exp((100.0 * std::log(4e6) + std::log(5e6)) / 101.0), 1.0);
  EXPECT_EQ(resolved.notes.size(), 2u);
  EXPECT_THAT(resolved.notes[1], HasSubstr("point 2, 4 Hz"));
}

TEST(Points, RefusesWhatTheyDoNotDetermine) {
  estimation::Specification specification;
  specification.setPoints({{4.0, 1e-3, 4e6, std::nullopt, 1.0}});
  EXPECT_THAT(refusal(estimation::Model::maxwell, specification, {}),
              HasSubstr("points: 1 values do not determine 3 free parameters"));
  specification.set("dynamic_stiffness", 4e6);
  EXPECT_THAT(refusal(estimation::Model::maxwell, specification, {}),
              HasSubstr("dynamic_stiffness: is given, but follows from points"));
}

}  // namespace
}  // namespace rubber_suspension
