// A diagnosis whose statements have to agree with each other: what tests of this folder make goes through here.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/search_evidence.h"
#include "diagnosis/results/contradictions.h"
#include "diagnosis/results/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension {

/// What the best hypothesis of so many effects is compared with has been fitted: one with a simpler law in the place of
/// each that contains one, and one of as many laws where it frees trends.
inline void checkWhatIsComparedWith(const diagnosis::Evidence& evidence, const diagnosis::HypothesisEvidence& best) {
  const auto competes = [&](int effect) {
    const diagnosis::HypothesisEvidence& single = evidence.single(effect);
    return single.terms > 0 && !single.like_parameters;
  };
  const std::vector<int>& members = best.members;
  if (!std::all_of(members.begin(), members.end(), competes)) {
    return;
  }
  for (const int member : members) {
    for (const int simpler : evidence.containedIn(member)) {
      if (competes(simpler) && std::find(members.begin(), members.end(), simpler) == members.end()) {
        std::vector<int> instead = members;
        std::replace(instead.begin(), instead.end(), member, simpler);
        EXPECT_TRUE(evidence.find(instead).has_value()) << simpler << " in the place of " << member;
      }
    }
  }
  EXPECT_TRUE(std::any_of(evidence.hypotheses.begin(), evidence.hypotheses.end(), [&](const auto& other) {
    return other.members.size() == members.size() && !other.free_trends;
  }));
}

/// The floor is no more than any fitted model leaves, and what the best hypotheses are compared with has been fitted:
/// also each pair within the best triple.
inline void checkEvidence(const diagnosis::Evidence& evidence) {
  const diagnosis::HypothesisEvidence* pair = nullptr;
  const diagnosis::HypothesisEvidence* triple = nullptr;
  for (std::size_t h = diagnosis::Evidence::kReEstimated; h < evidence.hypotheses.size(); ++h) {
    const diagnosis::HypothesisEvidence& hypothesis = evidence.hypotheses[h];
    if (!hypothesis.free_trends) {  // trends take slow noise with them
      EXPECT_LE(evidence.noise_floor, (1.0 + 1e-9) * hypothesis.held_out) << "hypothesis " << h;
    }
    pair = pair == nullptr && hypothesis.members.size() == 2 ? &hypothesis : pair;
    triple = triple == nullptr && hypothesis.members.size() == 3 ? &hypothesis : triple;
  }
  for (const diagnosis::HypothesisEvidence* best : {pair, triple}) {
    if (best != nullptr) {
      checkWhatIsComparedWith(evidence, *best);
    }
  }
  for (const int member : triple != nullptr ? triple->members : std::vector<int>{}) {
    std::vector<int> others = triple->members;
    others.erase(std::find(others.begin(), others.end(), member));
    EXPECT_TRUE(evidence.find(others).has_value()) << others[0] << " beside " << others[1];
  }
}

inline diagnosis::Diagnosis checkedDiagnosis(const io::ComponentDescription& component,
                                             const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out,
                                             const diagnosis::DiagnosisOptions& options = {}) {
  diagnosis::Diagnosis result = diagnosis::diagnose(component, logs, hold_out, options);
  for (const std::string& contradiction : diagnosis::contradictions(result)) {
    ADD_FAILURE() << contradiction << ": " << result.sentence;
  }
  if (result.workings) {
    checkEvidence(diagnosis::evidenceOf(result.workings->search));
  }
  return result;
}

}  // namespace rubber_suspension
