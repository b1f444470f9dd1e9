// A report whose statements contradict each other is detected and gets no verdict.
#include "diagnosis/invariants.h"

#include "diagnosis/hypotheses/workings.h"
#include "shared_runs.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using diagnosis::Diagnosis;

TEST(Invariants, HoldForReportsOfAllKinds) {
  for (const Diagnosis* run : {&ofNothing(), &ofAStop(), &ofHum(), &ofOneLog()}) {
    EXPECT_THAT(brokenInvariants(*run), testing::IsEmpty()) << run->sentence;
  }
}

TEST(Invariants, AreEachFoundBroken) {
  const std::vector<std::pair<std::string, std::function<void(Diagnosis&)>>> changes = {
      {"effects are named if and only if the verdict names effects", [](Diagnosis& d) { d.answer.effects.clear(); }},
      {"the probabilities add up to 1", [](Diagnosis& d) { d.answer.posterior.none += 0.01; }},
      {"the verdict is the most probable explanation",
       [](Diagnosis& d) { std::swap(d.answer.posterior.none, d.answer.posterior.effects); }},
      {"the probabilities of effects agree with the sets that contain them",
       [](Diagnosis& d) { d.candidates[0].probability = 0.0; }},
      {"the first set in the list is the named set", [](Diagnosis& d) { d.answer.confounded.front() = {"friction"}; }},
      {"no set contains an improbable effect", [](Diagnosis& d) { d.answer.confounded.push_back({"no effect"}); }},
      {"alternatives are sorted by probability", [](Diagnosis& d) { d.answer.alternatives.assign(3, {{}, {}, 0.5}); }},
      {"no other fit predicts unseen data better",
       [](Diagnosis& d) {
         auto workings = std::make_shared<diagnosis::Workings>(*d.workings);
         workings->search.singles.front().fit.gap = 1.03 * workings->search.singles.front().fit.held_out;
         d.workings = workings;
       }},
      {"the noise floor is not above any gap",
       [](Diagnosis& d) { d.gaps.unseen.noise_floor = 1.01 * d.gaps.unseen.augmented; }},
      {"with the verdict named, the gap falls and its interval excludes 0, or the data sheet is right",
       [](Diagnosis& d) { d.gaps.unseen.re_estimated = d.gaps.unseen.as_configured = 0.99 * d.gaps.unseen.augmented; }},
      {"the share closed agrees with the gaps", [](Diagnosis& d) { d.gaps.closed -= 0.01; }},
      {"the interval contains the share closed", [](Diagnosis& d) { d.gaps.closed_interval = {0.1, 0.2}; }},
      {"an interval that ends at a bound is marked",
       [](Diagnosis& d) { d.law.effect_sizes.front().interval_95[0] = 0.0; }},
      {"the parts removed from the logs add up", [](Diagnosis& d) { d.logs.admission.front().left *= 1.1; }},
      {"the parts removed from the logs explain the gaps", [](Diagnosis& d) { d.gap_as_recorded.augmented *= 1.1; }},
      {"the written file is not worse on any log",
       [](Diagnosis& d) { d.law.left_of_logs.front().written = 10.0 * d.law.left_of_logs.front().configured; }},
      {"the numbers of named effects equal the numbers in the written file",
       [](Diagnosis& d) { d.candidates.front().gap *= 1.01; }},
      {"each named effect removes some of the gap", [](Diagnosis& d) { d.shares.back().squares_at_least = -1e-6; }},
      {"the cells in `where` add up to the gap", [](Diagnosis& d) { d.where.after.front().squared *= 1.1; }},
      {"the shares in `where` add up to 1", [](Diagnosis& d) { d.where.before.front().share *= 0.5; }},
      {"with the verdict unknown or partly, there is a surrogate", [](Diagnosis& d) { d.surrogate.emplace(); }},
      {"there is a next experiment, or a reason for none", [](Diagnosis& d) { d.next.text.clear(); }}};
  for (const auto& [name, change] : changes) {
    Diagnosis changed = ofAStop();
    change(changed);
    EXPECT_THAT(brokenInvariants(changed), Contains(name));
  }
}

TEST(Defect, TellsNoVerdict) {
  Diagnosis changed = ofAStop();
  changed.gaps.unseen.re_estimated = changed.gaps.unseen.as_configured = changed.gaps.unseen.augmented;
  const Diagnosis told = heldToInvariants(std::move(changed));
  EXPECT_EQ(told.answer.verdict, diagnosis::Verdict::defect);
  EXPECT_TRUE(told.answer.effects.empty() && told.shares.empty() && told.candidates.empty());
  EXPECT_TRUE(told.law.effect_sizes.empty() && told.logs.taken_out.empty() && told.rig_findings.empty());
  EXPECT_FALSE(told.whole);
  EXPECT_TRUE(std::isnan(told.gaps.closed) && std::isnan(told.logs.admission.front().left));
  EXPECT_THAT(told.defect, HasSubstr("with the verdict named, the gap falls"));
  EXPECT_THAT(told.sentence, HasSubstr("No verdict"));
  EXPECT_NE(toJson(told).find("\"defect\": \"with the verdict named, the gap falls"), std::string::npos);
  const std::string folder = testing::TempDir() + "/defect";
  EXPECT_EQ(writeReport(told, folder), "");
  std::ifstream page(folder + "/report.html");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(page), {}), HasSubstr("no component file is written"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/augmented.yaml"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/figure_where.csv"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rubber_suspension
