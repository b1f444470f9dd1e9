// The evidence for the judgement: plain numbers from the fits, without simulations or logs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/free_in_log.h"

namespace rubber_suspension::diagnosis::judge {

/// A fitted hypothesis. Errors and sizes are mean squares in units of the variance of the force, infinite if the model
/// has no finite force on a log.
struct HypothesisEvidence {
  std::vector<int> members;  ///< indices of the effects at work, ascending
  std::size_t terms = 0;     ///< number of their basis terms; 0: the logs lack what they need
  /// Numbers beyond the laws that the members contain (fit::numbersBeyond()) that are not at their limits.
  std::size_t beyond = 0;
  fit::PerLogNuisances free_in_log;  ///< free in each log
  bool idle = false;                 ///< a member removes nothing beyond chance: the hypothesis is inadmissible
  bool keeps_values = false;         ///< model parameters are as configured: the member is equivalent to changing them
  double chi_squared = 0.0;          ///< of the deviations from the data sheet, in tolerances
  std::vector<double> log_errors;    ///< error on each log, in blocks that took no part in the fit
  /// Size of the force that each member adds to each log: a list over the logs for each member.
  std::vector<std::vector<double>> sizes;
  /// Shares of the octaves in the residual of each log; if empty, equal to the weights of the octaves.
  std::vector<std::vector<double>> shares;
};

/// A log that hypotheses are judged on, or a row of a table.
struct LogEvidence {
  double floor = 0.0;              ///< noise and errors of the rig within its tolerances, as a gap
  double floor_uncertainty = 0.0;  ///< standard error of its logarithm
  double weight = 1.0;             ///< of the log (Record::weight)
  bool unseen = false;             ///< took no part in the fit
  std::size_t blocks = 0;          ///< number of blocks with known errors
  /// Weights of the octaves of frequency, with a sum of 1 for a log; a single one if they are not distinguished.
  std::vector<double> octaves = {1.0};
};

/// The whole evidence. The first two hypotheses have no effect; they are followed by the single effects in their order,
/// pairs and triples.
struct Evidence {
  static constexpr int kAsConfigured = 0;
  static constexpr int kReEstimated = 1;
  static constexpr int kFirstSingle = 2;

  std::vector<HypothesisEvidence> hypotheses;
  std::vector<LogEvidence> logs;     ///< the logs of the fit, then the unseen ones
  std::vector<std::string> effects;  ///< names; members are indices into this list
  std::vector<bool> one_form;        ///< for each effect: its law has only one form, like that of a mass
  std::vector<bool> constant;        ///< for each effect: it adds a constant force, which has no form error
  /// For each effect: the effects that are limits of its law, which therefore contains them.
  std::vector<std::vector<int>> contains;
  bool guess = false;               ///< the data sheet is a guess, so that the model as configured is inadmissible
  std::vector<bool> excluded = {};  ///< for each effect: ruled out, with all its hypotheses; empty: none is

  const HypothesisEvidence& at(int hypothesis) const { return hypotheses[static_cast<std::size_t>(hypothesis)]; }

  /// Returns true if the values of a hypothesis lie nearer to the data sheet than those re-estimated without effects.
  bool isNearerToTheSheet(int hypothesis) const { return at(hypothesis).chi_squared < at(kReEstimated).chi_squared; }
};

}  // namespace rubber_suspension::diagnosis::judge
