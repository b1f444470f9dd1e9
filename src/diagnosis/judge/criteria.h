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
  double floor_margin = 1.03;        ///< the floor is known to some percent only
  double insignificant_gap = 0.006;  ///< of the force: smaller gaps are within the accuracy of discretisation
  double within_noise = 0.5;         ///< times the floor: less above the floor is noise

  // Whether an effect shows in these logs.
  double visible_share = 0.05;  ///< of a typical effect's force that re-estimation does not hide
  double visible_size = 0.2;    ///< times the floor: what is smaller disappears in the noise

  // Whether wrong model parameters explain the gap: they do where they leave noise only. Those of every element do
  // where the specification's values closed most of it.
  double share_left_before_elements = 0.4;  ///< of the gap as configured, by the specification's values
  /// By what all stiffnesses and damping of a specification err together, as the hardness of rubber does: standard
  /// deviation. A gain of the force channel within twice of it is the less likely reason.
  double values_err_by = 0.15;
  double changed_little = 0.06;  ///< logarithm of a model parameter: as specified
  std::size_t few_terms = 3;     ///< an effect of more numbers is no simpler than changed model parameters

  // Which effects are named.
  double chance = 0.05;  ///< that one more effect is no better; or the first, where parameters leave little
  /// One more effect has to reduce what is left below this part: a second one beside the first, one where parameters
  /// close the gap, and one that can look like several others, of the gap.
  double needs_another = 0.55;
  double clearly_less = 0.05;  ///< a larger law has to err less than a simpler one by this share, or is not worth it
  /// A gap closed by less than this is not explained: an effect beside something as large that the list lacks closes
  /// 0.29, 1 - 2^-0.5, of the root mean square.
  double unknown = 0.29;
  double partly = 0.7;  ///< closed by less than this: explained in part
  /// Of the squared gap: where some function of the motion predicts less, what it does not predict is no rest of an
  /// effect but noise, beside which a cause may close a small part of the gap.
  double larger_part = 0.5;

  // Probabilities over what is left: sharpness, and the blur within which nothing can be told apart, as parts of the
  // noise floor and of the gap. Fitted by maximum likelihood to cases of virtual rigs that take part in no trial.
  double sharpness = 3.0;
  double noise_blur = 0.2;
  double gap_blur = 0.015;
  double set_probability = 0.9;  ///< that the set of effects that cannot be told apart holds the right one

  double shows_nothing = 1.1;  ///< times the floor of unseen logs: such logs do not speak against wrong values

  // What is left beyond both is a rest that is not explained, whatever share is closed: `partly`; or, where model
  // parameters alone or nothing was to explain it, `unknown`. A vehicle engineer accepts 2 % of the force, and what is
  // less than the noise cannot be told from it.
  double beyond_noise = 0.02;          ///< of the force
  double beyond_noise_of_floor = 1.0;  ///< times the floor

  /// What may be left above a floor before it counts as not explained, as a gap.
  double beyondNoise(double floor) const { return std::max(beyond_noise, beyond_noise_of_floor * floor); }
};

}  // namespace rubber_suspension::diagnosis
