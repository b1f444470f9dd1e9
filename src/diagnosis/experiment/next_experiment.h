// The experiment that a report proposes.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/experiment/bounds.h"
#include "diagnosis/hypotheses/workings.h"
#include "fit/fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::experiment {

/// Result of the search for an experiment.
enum class Proposal {
  agrees,        ///< none is needed, because the model agrees with the measurement
  sure,          ///< none is needed, because the verdict is sure
  no_rival,      ///< none is possible, because no second explanation was fitted
  same_effects,  ///< none is needed, because all explanations name the same effects
  no_motion,     ///< none is possible, because no motion stays within the limits
  within_limits,
  beyond_limits,  ///< only an experiment beyond one of the limits distinguishes the explanations
  none
};

/// The limit that has to be widened for Proposal::beyond_limits.
enum class WiderLimit { stroke, speed, duration };

/// An experiment, or the reason why none is proposed.
struct NextExperiment {
  Proposal proposal = Proposal::none;
  std::vector<std::string> names;  ///< names of the explanations, the judged one first
  double open = 0.0;               ///< entropy of the question which effects are at work, summed over the effects [bit]
  std::string motion;              ///< best motion within the limits
  double open_after = 0.0;         ///< expected value of this entropy once `motion` is recorded [bit]
  std::string nearest;  ///< explanation that is nearest to the judged one on `motion`; empty if there is none
  WiderLimit limit = WiderLimit::stroke;
  Bounds wider;                   ///< bounds with this limit widened
  std::string wider_motion;       ///< best motion within the wider bounds
  double wider_open_after = 0.0;  ///< expected entropy once `wider_motion` is recorded [bit]
  ProposedExperiment proposed;    ///< the proposed experiment, which is within the limits
};

/// Returns the experiment after which the expected entropy of the question which effects are at work is smallest. If
/// none is proposed, the result states the reason and, if there is one, a wider limit that would admit an experiment.
NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads);

}  // namespace rubber_suspension::diagnosis::experiment
