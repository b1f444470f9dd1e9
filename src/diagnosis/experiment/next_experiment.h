// The experiment that a report proposes.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/experiment/bounds.h"
#include "diagnosis/hypotheses/workings.h"
#include "fit/fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::experiment {

/// Outcome of the search for an experiment, with the reason for none.
enum class Proposal {
  agrees,        ///< none: the model agrees with the measurement
  sure,          ///< none: the verdict is sure
  no_rival,      ///< none: no second explanation was fitted
  same_effects,  ///< none: all explanations name the same effects
  no_motion,     ///< none stays within the limits
  within_limits,
  beyond_limits,  ///< none within the limits, but one within a wider limit
  none
};

/// The limit that was widened.
enum class WiderLimit { stroke, speed, duration };

/// An experiment, or the reason why none is proposed.
struct NextExperiment {
  Proposal proposal = Proposal::none;
  std::vector<std::string> names;  ///< of the explanations, the judged one first
  double open = 0.0;               ///< entropy of the names: for each effect, whether it is at work [bit]
  std::string motion;              ///< best motion within the limits
  double open_after = 0.0;         ///< expected entropy after it [bit]
  std::string nearest;             ///< explanation nearest to the judged one in this motion; empty: none
  WiderLimit limit = WiderLimit::stroke;
  Bounds wider;                   ///< bounds with that limit
  std::string wider_motion;       ///< best motion within these bounds
  double wider_open_after = 0.0;  ///< expected entropy after it [bit]
  ProposedExperiment proposed;    ///< within the limits
};

/// Returns the experiment with the least expected entropy of the names of effects or, if none is proposed, the reason
/// and the wider limit within which one would be.
NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads);

}  // namespace rubber_suspension::diagnosis::experiment
