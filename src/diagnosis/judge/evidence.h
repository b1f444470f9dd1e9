// The evidence that the judgement is made of: plain numbers of the fits, no simulation and no logs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/free_in_log.h"

namespace rubber_suspension::diagnosis::judge {

/// A fitted hypothesis. Errors and sizes are mean squares in units of the variance of the force; what no model run
/// follows is infinite.
struct HypothesisEvidence {
  std::vector<int> members;  ///< effects at work, ascending
  std::size_t terms = 0;     ///< numbers that they add to the model; 0: the logs lack what they need
  /// Numbers beyond the laws that the members contain (fit::numbersBeyond()) that are not at their limits.
  std::size_t beyond = 0;
  fit::PerLogNuisances free_in_log;  ///< is free in each log, too
  bool idle = false;                 ///< a member removes nothing beyond chance: it is no answer
  bool keeps_values = false;         ///< model parameters are as configured: its member does what other ones would
  double chi_squared = 0.0;          ///< of the numbers of the data sheet, each over its tolerance
  std::vector<double> log_errors;    ///< error on each log, on blocks that took no part in the fit
  /// Size of the force that each member adds to each log.
  std::vector<std::vector<double>> sizes;
  /// Shares of the octaves in the residual of each log; empty: as their weights.
  std::vector<std::vector<double>> shares;
};

/// A log that hypotheses are judged on, or a row of a table.
struct LogEvidence {
  double floor = 0.0;              ///< noise and what the rig did within its tolerances, as a gap
  double floor_uncertainty = 0.0;  ///< standard error of its logarithm
  double weight = 1.0;             ///< of the log (Record::weight)
  bool unseen = false;             ///< took no part in the fit
  std::size_t blocks = 0;          ///< of which errors are known
  /// Weights of the octaves of frequency, with a sum of 1 for a log; a single one if they are not distinguished.
  std::vector<double> octaves = {1.0};
};

/// All of it. The first two hypotheses add no effect; then follow the single effects in their order, then pairs and
/// triples.
struct Evidence {
  static constexpr int kAsConfigured = 0;
  static constexpr int kReEstimated = 1;
  static constexpr int kFirstSingle = 2;

  std::vector<HypothesisEvidence> hypotheses;
  std::vector<LogEvidence> logs;     ///< those of the fit, then unseen ones
  std::vector<std::string> effects;  ///< names, by the numbers that members are
  std::vector<bool> one_form;        ///< of each effect: its law has one form, as that of a mass
  std::vector<bool> constant;        ///< of each effect: it adds a constant force, whose form is never wrong
  /// Effects that the law of each effect has as limits and so contains; empty for most.
  std::vector<std::vector<int>> contains;
  bool guess = false;               ///< the data sheet is a guess, so that the model as configured is no answer
  std::vector<bool> excluded = {};  ///< of each effect: it is ruled out, as all hypotheses with it; empty: none is

  const HypothesisEvidence& at(int hypothesis) const { return hypotheses[static_cast<std::size_t>(hypothesis)]; }

  /// Returns true if the values of a hypothesis lie nearer to the data sheet than those re-estimated without effects.
  bool isNearerToTheSheet(int hypothesis) const { return at(hypothesis).chi_squared < at(kReEstimated).chi_squared; }
};

}  // namespace rubber_suspension::diagnosis::judge
