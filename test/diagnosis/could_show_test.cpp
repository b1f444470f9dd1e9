// Plans state which effects planned logs could show. They are compared with known answers and real fits.
#include <nlohmann/json.hpp>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/implant.h"
#include "diagnosis/hypotheses/screening.h"
#include "diagnosis/judge/numbers.h"
#include "fit/fitter.h"
#include "gap/simulate.h"
#include "rig.h"
#include "rubber_suspension/diagnosis/plan.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using diagnosis::ImplantedEffect;

log::Log programme(const std::function<double(double)>& law) {
  return logOf("programme", 5000, 4000000, [&](int i) { return std::min(1.0, 0.004 * i) * law(0.004 * i); });
}

log::Log sine() {
  return programme([](double t) { return 0.002 * std::sin(2.0 * element::kPi * 3.0 * t); });
}

log::Log sweep() {
  return programme([](double t) {
    return (0.0011 + 0.0009 * std::sin(0.7 * t)) * std::sin(2.0 * element::kPi * (0.2 * t + 0.25 * t * t));
  });
}

diagnosis::Plan planOf(const std::vector<log::Log>& logs, double size = 0.1) {
  diagnosis::PlanOptions options;
  options.size = size;
  options.threads = 1;
  return diagnosis::plan(rigComponent(), logs, options);
}

/// The plan that several tests check.
const diagnosis::Plan& planOfASweep() {
  static const diagnosis::Plan plan = planOf({sweep()});
  return plan;
}

const ImplantedEffect& row(const diagnosis::Plan& plan, const std::string& effect) {
  const auto& rows = plan.could_show.implanted;
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const ImplantedEffect& other) { return other.effect == effect; });
  if (found == rows.end()) {
    throw std::logic_error(effect);
  }
  return *found;
}

// At a single frequency, the three parameters of the model can fit the stiffness and loss of any linear law, within
// their prior. A delay within the rig's tolerance hides other effects there.
TEST(Plan, OneSineHidesWhatASweepFinds) {
  constexpr double kUsual = 0.06;  // size of an effect relative to the force
  const diagnosis::Plan one = planOf({sine()}, kUsual);
  const diagnosis::Plan many = planOf({sweep()}, kUsual);
  for (const char* effect : {"viscous_damping", "inertia"}) {
    EXPECT_GT(row(one, effect).least_size, row(many, effect).least_size) << effect;
    EXPECT_THAT(row(many, effect).outcome, testing::AnyOf("found", "confounded")) << effect;
    EXPECT_LT(row(many, effect).least_size, kUsual) << effect;
  }
}

// Offsets that differ between logs are attributed to the rig, not to an effect.
TEST(Plan, NeverFindsAZeroThatTheRigMayHave) {
  const diagnosis::Plan& plan = planOfASweep();
  EXPECT_EQ(row(plan, "force_offset").outcome, "out_of_reach");
  EXPECT_TRUE(std::isinf(row(plan, "force_offset").least_size));
}

TEST(Plan, LeastSizesAreWhereFindingBegins) {
  const diagnosis::Plan& plan = planOfASweep();
  for (const char* effect : {"friction", "bump_stop", "viscous_damping"}) {
    const double least = row(plan, effect).least_size;
    ASSERT_TRUE(std::isfinite(least)) << effect;
    EXPECT_THAT(row(planOf({sweep()}, 1.1 * least), effect).outcome, testing::AnyOf("found", "confounded")) << effect;
    EXPECT_THAT(row(planOf({sweep()}, 0.5 * least), effect).outcome,
                testing::Not(testing::AnyOf("found", "confounded")))
        << effect;
  }
}

TEST(Plan, SharesOfShapesAddUp) {
  const diagnosis::Plan& plan = planOfASweep();
  for (const ImplantedEffect& effect : plan.could_show.implanted) {
    double sum = effect.nothing_named;
    for (const double share : effect.named_as) {
      sum += share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-9) << effect.effect;
  }
}

TEST(Plan, DoesNotLookAtAMeasuredForce) {
  log::Log with = sweep();
  with.force.assign(with.size(), 1.0);
  EXPECT_EQ(diagnosis::toJson(planOf({with})), diagnosis::toJson(planOfASweep()));
}

TEST(Plan, RefusesWhatCannotBePlayed) {
  log::Log still = sweep();
  std::fill(still.displacement.begin(), still.displacement.end(), 0.001);
  EXPECT_THROW(planOf({still}), log::LogError);
  log::Log brief = sweep();
  brief.stamp.resize(50);
  brief.displacement.resize(50);
  EXPECT_THROW(planOf({brief}), log::LogError);
  EXPECT_THROW(planOf({}), log::LogError);
}

TEST(Plan, WritesWhatItSays) {
  const diagnosis::Plan& plan = planOfASweep();
  const auto json = nlohmann::json::parse(diagnosis::toJson(plan));
  EXPECT_EQ(json["schema"], "rubber_suspension/experiment_plan/1");
  const std::string text = diagnosis::toText(plan.could_show);
  ASSERT_EQ(json["could_show"]["implanted"].size(), plan.could_show.implanted.size());
  for (std::size_t i = 0; i < plan.could_show.implanted.size(); ++i) {
    const ImplantedEffect& effect = plan.could_show.implanted[i];
    EXPECT_EQ(json["could_show"]["implanted"][i]["effect"], effect.effect);
    EXPECT_EQ(json["could_show"]["implanted"][i]["outcome"], effect.outcome);
    EXPECT_THAT(text, testing::HasSubstr(effect.effect));
  }
  EXPECT_THAT(text, testing::HasSubstr(json["could_show"]["implanted"][0]["least_size_text"].get<std::string>()));
  const auto folder = std::filesystem::path(testing::TempDir()) / "plan";
  EXPECT_EQ(diagnosis::writePlan(plan, folder.string()), "");
  std::ifstream page(folder / "plan.html");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(page), {}), testing::HasSubstr("Experiment plan"));
  std::filesystem::remove_all(folder);
}

// The residual predicted by projection equals the residual of a real fit to a force with the effect added.
TEST(Implants, LeaveWhatAFitLeaves) {
  const fit::ModelParameters model(rigComponent(), fit::Level::specification);
  const std::vector<gap::PreparedRecord> records = {log::makeRecord(runRig("plain", 1, nothing, 2.0))};
  const fit::Fitter fitter(records, model, kOneDeviation);
  auto candidates = diagnosis::candidates(fit::summarise(records));
  fit::findUnitEffects(candidates, records, 1);
  diagnosis::hypotheses::FittedHypothesis about;
  about.fit.parameters = fitter.configured(about.hypothesis);
  const diagnosis::hypotheses::Screening screening(fitter, candidates, about, 1);
  constexpr double kSize = 0.05;
  int compared = 0;
  for (const diagnosis::hypotheses::Implant& implant : diagnosis::hypotheses::implantAll(fitter, screening, 1)) {
    const fit::Candidate& candidate = candidates[static_cast<std::size_t>(implant.effect)];
    const fit::BasisTerm& term = candidate.terms[implant.term];
    if (implant.adds_nothing || !term.additive || !term.unit_effect || implant.model.gap < 0.2) {
      continue;
    }
    std::vector<gap::PreparedRecord> with = records;
    with.front().force += kSize * implant.scale * (*term.unit_effect)[0];
    const fit::Fitter fitted(with, model, kOneDeviation);
    const double left = fitted.fit({}, fitted.configured({}), {10}).gap;
    // The tolerance covers the nonlinearity of the model in its parameters and noise of 0.2 % of the force.
    EXPECT_NEAR(left, kSize * implant.model.gap, 0.1 * kSize) << candidate.effect << " " << implant.term;
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace rubber_suspension
