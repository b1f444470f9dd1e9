// All thresholds of the judgement, each with its reason.
#pragma once

#include <algorithm>
#include <cstddef>

namespace rubber_suspension::diagnosis {

/// "Left" is what a hypothesis leaves above the noise floor, regularisation penalty included (see Weighing); "the gap"
/// is what re-estimation of the model parameters leaves.
struct Criteria {
  std::size_t most_effects = 3;  ///< named at once

  // What counts as noise.
  double floor_margin = 1.03;         ///< the floor is known to some percent only
  double insignificant_gap = 0.006;   ///< of the force: smaller gaps are within the accuracy of discretisation
  double discretisation = 1.2;        ///< times what the model errs by at these time steps and this noise
  double within_noise = 0.5;          ///< times the floor: less above the floor is noise
  double share_of_gap_enough = 0.16;  ///< what may remain of the gap without a search for one more effect, within noise
  double trend_penalty = 0.1;         ///< of the gap, on a free trend per log, which follows whatever is slow

  // Whether an effect shows in these logs.
  double visible_share = 0.05;  ///< of a typical effect's force that re-estimation does not hide
  double visible_size = 0.2;    ///< times the floor: what is smaller disappears in the noise
  double shows = 0.67;          ///< of the gap: an effect that leaves less does show, typical or not
  double contributes = 0.67;    ///< an effect without which this part would be more than is left does show

  // Whether wrong model parameters explain the gap.
  double share_left_by_parameters = 0.12;   ///< of the gap as configured: so little is left that it counts as closed
  double above_noise_by_parameters = 2.5;   ///< times the floor: more must not be left, whatever share of it is closed
  double share_left_by_elements = 0.3;      ///< of the gap, with every parameter of every element free
  double share_left_before_elements = 0.4;  ///< of the gap as configured: the specification's values closed most
  // Whether an effect hides behind re-estimated parameters: one number more explains as much, with parameters close to
  // the configured ones, as re-estimation does that has to move several far.
  /// By what all stiffnesses and damping of a specification err together, as the hardness of rubber does: standard
  /// deviation. A gain of the force channel within twice of it is the less likely reason.
  double values_err_by = 0.15;
  double changed_far = 0.14;        ///< logarithm of a model parameter: beyond what a specification errs by
  double changed_little = 0.06;     ///< logarithm of a model parameter: as specified
  double hides = 0.3;               ///< part of the gap that a hidden effect may leave
  double hides_as_specified = 0.6;  ///< the same where the model parameters stay as specified
  std::size_t few_terms = 3;        ///< an effect of more numbers is no simpler than changed model parameters

  // Which effects are named.
  double family_gain = 0.05;    ///< by so much a law has to err less than a simpler one that it contains
  double chance = 0.05;         ///< that one more effect is no better; or the first, where parameters leave little
  double needs_another = 0.55;  ///< one more effect has to reduce what is left below this part
  double worth_naming = 0.15;   ///< or else by this part of the gap
  double unknown = 0.33;        ///< a gap closed by less than this is not explained
  double partly = 0.7;          ///< closed by less than this: explained in part
  // A last resort can look like several other effects: it is named where it leaves little, and all others much more.
  double last_resort_left = 0.5;        ///< of the gap, at most
  double last_resort_of_others = 0.67;  ///< of what all others leave, at most

  // Probabilities over what is left: sharpness, and the blur within which nothing can be told apart, as parts of the
  // noise floor and of the gap. Fitted by maximum likelihood to cases of virtual rigs that take part in no trial.
  double sharpness = 3.0;
  double noise_blur = 0.2;
  double gap_blur = 0.015;
  double set_probability = 0.9;  ///< that the set of effects that cannot be told apart holds the right one

  // A trend follows whatever is slow, creep for one, but predicts nothing: where effects without a trend close this
  // part of the gap of unseen logs, and this much more of it than with a trend, these are named.
  double predicts = 0.5;
  double predicts_clearly_more = 0.15;

  // Effects are named only if they close part of the gap of unseen logs; or lose little there, where changed model
  // parameters would do as well, or where the effect is a drift, which cannot be predicted.
  double least_closed_unseen = 0.05;
  double little_lost_unseen = 1.2;  ///< times the gap of unseen logs, and their floor on top
  double shows_nothing = 1.1;       ///< times the floor: such logs speak neither for an effect nor against it

  /// What no effect, or a drift in part, explains and unseen logs do not show is noise in the band of the motion; but
  /// not above this many floors on the logs of the fit.
  double unconfirmed_is_noise = 2.5;

  // What is left beyond both is a rest that is not explained, whatever share is closed: `partly`; or, where model
  // parameters alone or nothing was to explain it, `unknown`. A vehicle engineer accepts 2 % of the force.
  double beyond_noise = 0.02;          ///< of the force
  double beyond_noise_of_floor = 5.0;  ///< times the floor

  /// What may be left above a floor before it counts as not explained, as a gap.
  double beyondNoise(double floor) const { return std::max(beyond_noise, beyond_noise_of_floor * floor); }
};

}  // namespace rubber_suspension::diagnosis
