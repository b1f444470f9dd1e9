// Effects that logs could have shown: the judgement of each if it is added at a stated size. Throws nothing.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::diagnosis {

/// Judgement of one effect, implanted in several shapes of its law: added to forces that the model explains otherwise.
/// Shares are of the number of shapes.
struct ImplantedEffect {
  std::string effect;
  std::string outcome;                 ///< of most shapes: found, confounded, taken_for, unexplained, or out_of_reach
  std::vector<std::string> taken_for;  ///< effects named in its place or not distinguished from it
  std::vector<double> named_as;        ///< share of the shapes for which each effect of the list would be named first
  double nothing_named = 0.0;          ///< share of the shapes for which no effect would be named
  double visible_share = 0.0;          ///< part of its force that re-estimated model parameters do not hide [-]
  double least_size = 0.0;  ///< least RMS force, over the force's standard deviation, at which half of the shapes are
  ///< found, alone or in a set without wrong values; infinite if above 1
};

struct CouldShow {
  double size = 0.0;                 ///< RMS force of the implanted effects over the force's standard deviation
  double force = 0.0;                ///< this RMS force [N], in the log with the largest force
  std::string why;                   ///< where the size comes from
  double noise = 0.0;                ///< noise floor in units of the force's standard deviation
  std::vector<std::string> effects;  ///< all effects, in the order of `named_as`
  std::vector<ImplantedEffect> implanted;
};

}  // namespace rubber_suspension::diagnosis
