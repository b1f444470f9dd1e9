// Effects that logs could have shown, with the predicted judgement if each is added at a stated size. Throws nothing.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::diagnosis {

/// Predicted judgement of logs to which the force of one effect is added and which the model explains otherwise. It is
/// predicted for several forms of the law of the effect; shares are fractions of the number of forms.
struct ImplantedEffect {
  std::string effect;
  /// found or confounded if at least half of the forms are either; otherwise the most frequent one of found,
  /// confounded, taken_for, unexplained and out_of_reach
  std::string outcome;
  std::vector<std::string> taken_for;  ///< effects or wrong values named in its place or not distinguished from it
  std::vector<double> named_as;        ///< for each effect: fraction of the forms for which it would be named first
  double nothing_named = 0.0;          ///< fraction of the forms for which no effect would be named
  double visible_share = 0.0;          ///< part of its force that re-estimated model parameters do not absorb [-]
  /// Smallest RMS force, divided by the standard deviation of the force, at which half of the forms are found or
  /// confounded and wrong values are not an alternative; infinite if this ratio would exceed 1.
  double least_size = 0.0;
};

struct CouldShow {
  double size = 0.0;                 ///< RMS force of the added effects divided by the standard deviation of the force
  double force = 0.0;                ///< the same RMS force in newtons, for the log with the largest force [N]
  std::string why;                   ///< explains how the size was chosen
  double noise = 0.0;                ///< noise floor in units of the force's standard deviation
  std::vector<std::string> effects;  ///< all effects, in the order of `named_as`
  std::vector<ImplantedEffect> implanted;
};

}  // namespace rubber_suspension::diagnosis
