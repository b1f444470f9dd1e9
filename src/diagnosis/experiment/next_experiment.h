// The experiment that a report proposes.
#pragma once

#include <string>

#include "diagnosis/hypotheses/workings.h"
#include "fit/fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::experiment {

/// An experiment in words, and what to play.
struct NextExperiment {
  std::string text;
  ProposedExperiment proposed;
};

/// Fewer noise floors between explanations that were refitted decide nothing: no such experiment is proposed.
constexpr double kLeastFloors = 2.0;

/// The experiment after which the explanations of the logs that cannot be told apart are expected to differ most; or
/// why there is none, and what it would take.
NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads);

}  // namespace rubber_suspension::diagnosis::experiment
