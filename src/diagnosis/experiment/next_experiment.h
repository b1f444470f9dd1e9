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
  sure,          ///< none: the verdict is
  no_rival,      ///< none: no second explanation was fitted
  same_effects,  ///< none: all explanations name the same effects
  no_motion,     ///< none stays within the limits
  within_limits,
  beyond_limits,  ///< none within the limits, one within a wider one
  none
};

/// A limit that is wider than it was given.
enum class WiderLimit { stroke, speed, duration };

/// An experiment, or what keeps it from being one.
struct NextExperiment {
  Proposal proposal = Proposal::none;
  std::vector<std::string> names;  ///< of the explanations, that judged first
  double open = 0.0;               ///< entropy of the names: of each effect, whether it is at work [bit]
  std::string motion;              ///< that tells most within the limits
  double open_after = 0.0;         ///< expected after it [bit]
  std::string nearest;             ///< explanation that comes nearest to that judged in it; empty: none
  WiderLimit limit = WiderLimit::stroke;
  Bounds wider;                   ///< with that limit
  std::string wider_motion;       ///< that tells most within these
  double wider_open_after = 0.0;  ///< likewise [bit]
  ProposedExperiment proposed;    ///< within the limits
};

/// The experiment after which least is expected to be open about the names of effects; or why there is none, and what
/// it would take.
NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads);

}  // namespace rubber_suspension::diagnosis::experiment
