// Runs a diagnosis and checks that its statements agree with each other.
#pragma once

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/diagnosis/table_diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {

/// Checks that each hypothesis fits the logs at least as well as any other whose terms it contains, within 1 % plus a
/// tenth of the noise floor.
inline void checkContainment(const diagnosis::Diagnosis& d) {
  using diagnosis::hypotheses::FittedHypothesis;
  constexpr double kAsMuch = 1.01;
  constexpr double kOfFloor = 0.1;
  const diagnosis::hypotheses::Search& search = d.workings->search;
  const std::vector<const FittedHypothesis*> all = search.withEffects();
  for (const FittedHypothesis* larger : all) {
    for (const FittedHypothesis* smaller : all) {
      if (larger != smaller && smaller->hypothesis.competes() &&
          fit::holds(search.candidates, larger->hypothesis.members, smaller->hypothesis.members)) {
        EXPECT_LE(larger->fit.gap, kAsMuch * smaller->fit.gap + kOfFloor * search.noise.floor)
            << diagnosis::experiment::nameOf(search, *larger) << " above "
            << diagnosis::experiment::nameOf(search, *smaller);
      }
    }
  }
}

inline diagnosis::Diagnosis checkedDiagnosis(const io::ComponentDescription& component,
                                             const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out,
                                             const diagnosis::DiagnosisOptions& options = {}) {
  diagnosis::Diagnosis result = diagnosis::diagnose(component, logs, hold_out, options);
  EXPECT_EQ(result.defect, "");
  if (result.workings) {
    checkContainment(result);
  }
  return result;
}

inline diagnosis::Diagnosis checkedTable(const io::ComponentDescription& component, const fit::MeasuredTable& table) {
  diagnosis::Diagnosis result = diagnosis::diagnoseTable(component, table);
  EXPECT_EQ(result.defect, "");
  return result;
}

/// Returns true if the effect is named alone or is an alternative by itself.
inline bool mayBe(const diagnosis::Diagnosis& diagnosis, const std::string& effect) {
  const auto is = [&](const diagnosis::Alternative& other) {
    return other.effects == std::vector<std::string>{effect};
  };
  return diagnosis.answer.effects == std::vector<std::string>{effect} ||
         std::any_of(diagnosis.answer.alternatives.begin(), diagnosis.answer.alternatives.end(), is);
}

}  // namespace rubber_suspension
