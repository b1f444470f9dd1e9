// Effects that logs could have shown: the findings for each, implanted at a stated size. Throws nothing.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::diagnosis {

/// One effect, had it been at work. It is implanted in several shapes of its law; shares are of these.
struct ImplantedEffect {
  std::string effect;
  std::string outcome;                 ///< found, confounded, taken_for, unexplained, or out_of_reach; of most shapes
  std::vector<std::string> taken_for;  ///< effects named in its place or not distinguished from it
  std::vector<double> named_as;        ///< share of the shapes for which each effect of the list would be named first
  double nothing_named = 0.0;          ///< share for which none would
  double visible_share = 0.0;          ///< of its force, the part that re-estimated model parameters do not hide
  double least_size = 0.0;  ///< RMS force over the force's standard deviation from which half of the shapes are found,
                            ///< alone or in a set without wrong values; infinite where that is more than all of it
};

struct CouldShow {
  double size = 0.0;                 ///< of the implanted effects: RMS force over the force's standard deviation
  double force = 0.0;                ///< the same [N], in the log with the largest force
  std::string why;                   ///< where the size comes from
  double noise = 0.0;                ///< floor in units of the force's standard deviation
  std::vector<std::string> effects;  ///< the list, in the order of `named_as`
  std::vector<ImplantedEffect> implanted;
};

}  // namespace rubber_suspension::diagnosis
