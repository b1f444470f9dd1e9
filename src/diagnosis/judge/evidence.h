// The evidence for the judgement: plain numbers, so that the judgement needs neither logs nor simulations.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/free_in_log.h"

namespace rubber_suspension::diagnosis::judge {

/// The numbers of a fitted hypothesis. Errors and sizes are mean squares divided by the variance of the force. They are
/// infinite if the model has no finite force on a log.
struct HypothesisEvidence {
  std::vector<int> members;  ///< indices of the effects of the hypothesis, ascending
  std::size_t terms = 0;     ///< number of basis terms of these effects; 0 if the logs lack what the effects need
  /// Number of nonzero parameters beyond those of the laws that the effects contain (fit::numbersBeyond()).
  std::size_t beyond = 0;
  fit::PerLogNuisances free_in_log;  ///< parameters that are free in each log
  bool idle = false;          ///< an effect removes no more than chance would, so that the hypothesis is inadmissible
  bool keeps_values = false;  ///< model parameters are as configured, because the effect is equivalent to changing them
  double chi_squared = 0.0;   ///< sum of the squares of (deviation from the data sheet / its tolerance)
  std::vector<double> log_errors;  ///< for each log: error in blocks that took no part in the fit
  /// For each member, a list over the logs: size of the force that the member adds.
  std::vector<std::vector<double>> sizes;
  /// For each log: fractions of the squared residual in each octave. If empty, they equal the weights of the octaves.
  std::vector<std::vector<double>> shares;
};

/// A log on which hypotheses are judged, or a row of a table.
struct LogEvidence {
  double floor = 0.0;              ///< noise and errors of the rig within its tolerances, expressed as a gap
  double floor_uncertainty = 0.0;  ///< standard error of the logarithm of `floor`
  double weight = 1.0;             ///< weight of the log (Record::weight)
  bool unseen = false;             ///< the log took no part in the fit
  std::size_t blocks = 0;          ///< number of blocks in which errors are known
  /// Weights of the octaves of frequency, which add up to 1. A single weight stands for all octaves together.
  std::vector<double> octaves = {1.0};
};

/// The whole evidence. The first two hypotheses have no effect. They are followed by a hypothesis for each single
/// effect, in the order of `effects`, and by those with two and three effects.
struct Evidence {
  static constexpr int kAsConfigured = 0;
  static constexpr int kReEstimated = 1;
  static constexpr int kFirstSingle = 2;

  std::vector<HypothesisEvidence> hypotheses;
  std::vector<LogEvidence> logs;     ///< the logs of the fit, followed by the unseen logs
  std::vector<std::string> effects;  ///< names of the effects; HypothesisEvidence::members are indices of this list
  std::vector<bool> one_form;        ///< for each effect: its law has only one possible form, as for a mass
  std::vector<bool> constant;        ///< for each effect: it adds a constant force, for which there is no form error
  /// For each effect: the effects that its law contains, because they are limits of this law.
  std::vector<std::vector<int>> contains;
  bool guess = false;               ///< the data sheet is a guess, so that the model as configured is inadmissible
  std::vector<bool> excluded = {};  ///< for each effect: its hypotheses are inadmissible; empty if none is excluded

  const HypothesisEvidence& at(int hypothesis) const { return hypotheses[static_cast<std::size_t>(hypothesis)]; }
};

}  // namespace rubber_suspension::diagnosis::judge
