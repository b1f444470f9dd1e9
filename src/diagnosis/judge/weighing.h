// What hypotheses leave above the noise floor, and what that says of them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"
#include "diagnosis/judge/paired_losses.h"

namespace rubber_suspension::diagnosis {

/// All numbers in units of the force's standard deviation. The evidence and criteria have to outlive it.
class Weighing {
 public:
  Weighing(const Evidence& evidence, const Criteria& criteria) : evidence_(evidence), criteria_(criteria) {}

  /// What an error (RMS) is above the noise floor.
  double left(double error) const;

  /// What a fitted hypothesis leaves above the noise floor, its penalties included.
  double left(const HypothesisEvidence& hypothesis) const;

  /// Less above the floor cannot be told from noise and discretisation, and calls for no further effect, however large
  /// the gap was: one large effect must not hide another.
  double insignificant() const;

  /// Less above the floor, left by re-estimated parameters, calls for no effect.
  double tolerated() const;

  /// The hypothesis of the single effect that leaves least, if any may be a cause.
  std::optional<int> bestSingle() const;

  /// True if re-estimated model parameters leave noise only.
  bool closedByParameters() const;

  /// True unless the hypothesis frees trends that explain no more than slow noise of the rig may be, or a gain of each
  /// log that may be what heating or softening beside it do.
  bool mayBeACause(const HypothesisEvidence& hypothesis) const;

  /// What only the trends of a hypothesis explain, as a gap: not the model, nor its other effects, nor the same ones
  /// with the simpler effect that a trend contains.
  double explainedByTrends(const HypothesisEvidence& hypothesis) const;

  /// What only trends explain, and little enough to be slow noise of the rig, as a gap.
  double slowNoise() const;

  /// True if so much is left that it counts as not explained.
  bool isBeyondNoise(double rest, double floor) const { return rest > criteria_.beyondNoise(floor); }
  bool isBeyondNoise(const UnseenErrors& errors) const;

  /// The same of a hypothesis, on the logs of the fit or on unseen ones.
  bool isBeyondNoise(const HypothesisEvidence& hypothesis) const;

  /// What is left of unseen logs above their floor.
  static double leftUnseen(const UnseenErrors& errors);

  /// Of the logarithms of errors, paired by blocks: negative where the first errs less. Of one log, blocks hang
  /// together where there are three logs or more. Without a standard error where errors of blocks are not known.
  PairedDifference difference(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;

  /// True if the first errs less by more than one standard error of the paired difference (Breiman et al.,
  /// Classification and Regression Trees, 1984, section 3.4.3) and than what is worth a larger law.
  bool errsLess(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;

  /// Probability of such a gain over another hypothesis where there is none; 0 where errors of blocks are not known.
  double chanceOfGain(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;

  /// What it leaves of the residual above the floor: without what moved parameters cost.
  double residualOf(const HypothesisEvidence& hypothesis) const;

  /// True if the first leaves so little of what the other does as one more effect has to (Criteria::needs_another): of
  /// the residual, since what moved parameters cost both alike must not hide a gain.
  bool gainsEnough(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;

  /// True if a hypothesis closes part of the gap that another leaves of data that took no part in the fit, beyond
  /// chance: the interval of what it closes excludes 0. True where parts of the errors are not known.
  bool closesForSure(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;

  /// The hypothesis of the best effect of few numbers that leaves much less than re-estimated parameters once it counts
  /// how far either moves the values of the specification, if any: one number more in place of values that are off by
  /// more than a specification errs.
  std::optional<int> simplerThanParameters() const;

  /// The hypothesis of the best effect, if it leaves much less of unseen logs than re-estimated parameters, and these
  /// are refuted there.
  std::optional<int> betterUnseen() const;

 private:
  /// The hypothesis of the single effect that leaves least, of those that count, if any.
  std::optional<int> bestOf(const std::function<bool(const HypothesisEvidence& single)>& counts) const;
  bool logsAreClusters() const;
  Losses lossesOf(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;
  bool knowsBlocks(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const;
  std::vector<gap::PartError> partsOf(const HypothesisEvidence& hypothesis) const;

  // Gains of each log beside heating or softening, which change from log to log, too, and whose laws leave something:
  // they have to gain what two further effects would.
  bool gainsAreHistory(const HypothesisEvidence& hypothesis) const;

  const Evidence& evidence_;
  const Criteria& criteria_;
};

/// True if a search should go on to pairs of effects: what the single ones leave calls for it.
bool needsFurtherEffects(const Evidence& evidence, const Criteria& criteria);

}  // namespace rubber_suspension::diagnosis
