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

/// The experiment after which least is expected to be open about the names of effects; or why there is none, and what
/// it would take.
NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads);

}  // namespace rubber_suspension::diagnosis::experiment
