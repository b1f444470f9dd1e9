// What the judgement is made of: plain numbers of the fits, no simulation and no logs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {

/// A fitted hypothesis on logs that took no part in the fit: what it predicts from the displacement smoothed as for the
/// fits, since the noise of that sensor is the rig's. Gaps are over all of them.
struct UnseenErrors {
  double gap = 0.0;
  double noise_floor = 0.0;                ///< by what this hypothesis leaves
  std::vector<gap::PartError> parts = {};  ///< of the gap; may be empty
};

/// A fitted hypothesis. Errors are gaps: RMS residuals in units of the standard deviation of the force.
struct HypothesisEvidence {
  std::vector<int> members;          ///< effects at work, ascending
  std::size_t terms = 0;             ///< numbers that they add to the model
  bool free_trends = false;          ///< a slow trend per log is free, too
  bool free_gains = false;           ///< a gain per log is free, too
  bool history = false;              ///< changes the stiffness from log to log by what was before
  bool sensor = false;               ///< has an error of the force channel, which the motion does not cause
  bool last_resort = false;          ///< may look like several other effects
  bool like_parameters = false;      ///< re-estimated parameters do the same: never named by itself
  bool within_tolerance = false;     ///< of such a one: no more than the rig may do
  double held_out = 0.0;             ///< on blocks that took no part in the fit
  double penalty = 0.0;              ///< regularisation penalty of changed model parameters
  double at_least = 0.0;             ///< what it leaves counts as no less than this (settleFamilies())
  bool does_no_better = false;       ///< than with a simpler law that one of its laws contains (settleFamilies())
  double largest_change = 0.0;       ///< largest |ln(value/configured)| of a model parameter
  std::vector<double> block_errors;  ///< mean square error of each of those blocks; may be empty
  std::vector<double> log_errors;    ///< mean square error on each log (Evidence::logs); may be empty
  /// Of each member, mean square of the force that it adds to each log, in units of the force's variance; may be empty.
  std::vector<std::vector<double>> sizes;
  std::optional<UnseenErrors> unseen;

  /// Whether each log frees something of its own.
  bool freesInLogs() const { return free_trends || free_gains; }
};

/// A log that hypotheses are judged on.
struct LogEvidence {
  double floor = 0.0;              ///< noise, as a gap
  double floor_uncertainty = 0.0;  ///< standard error of its logarithm
  double weight = 1.0;             ///< of the log (Record::weight)
  bool unseen = false;             ///< took no part in the fit
};

/// All of it. The first two hypotheses add no effect; then follow the single effects in their order, then pairs and
/// triples, each best first.
struct Evidence {
  static constexpr int kAsConfigured = 0;
  static constexpr int kReEstimated = 1;
  static constexpr int kFirstSingle = 2;

  std::vector<HypothesisEvidence> hypotheses;
  std::vector<LogEvidence> logs;           ///< those of the fit, then unseen ones; may be empty
  std::vector<int> block_logs;             ///< the log that each block is of
  std::vector<double> block_weights;       ///< of each block
  std::vector<bool> testable;              ///< per effect: a typical size of it would show in these logs
  std::vector<std::vector<int>> contains;  ///< per effect: simpler ones that its law contains; empty: none does
  double element_level = 0.0;              ///< held-out error with every parameter of every element of the model free
  double noise_floor = 0.0;                ///< of the logs of the fit
  double slow_noise = 0.0;                 ///< what a rig may add by slow noise and drift, as a gap
  double discretisation = 0.0;             ///< what the model errs by at the time steps of the logs
  /// Part of the squared gap above the floor that some function of the motion predicts where it was not fitted, over
  /// the model without effects; 1 where it is not known.
  double caused_by_motion = 1.0;
  bool has_unseen_logs = false;  ///< whether `unseen` of a hypothesis can be had
  int resamplings = 400;         ///< of parts of the logs, for intervals
  unsigned seed = 1;             ///< of these

  const HypothesisEvidence& at(int hypothesis) const { return hypotheses[static_cast<std::size_t>(hypothesis)]; }
  const HypothesisEvidence& reEstimated() const { return at(kReEstimated); }
  const HypothesisEvidence& single(int effect) const { return at(kFirstSingle + effect); }
  int effects() const { return static_cast<int>(testable.size()); }

  /// Simpler effects that the law of an effect contains.
  std::vector<int> containedIn(int effect) const;

  /// The hypothesis of these effects, in any order; none where it was not fitted.
  std::optional<int> find(std::vector<int> members) const;

  /// A hypothesis without one of its effects, or with another in its place.
  std::optional<int> without(int hypothesis, int effect) const;
  std::optional<int> inPlaceOf(int hypothesis, int effect, int other) const;
};

}  // namespace rubber_suspension::diagnosis
