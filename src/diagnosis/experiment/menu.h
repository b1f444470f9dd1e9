// The menu of motions that an experiment may consist of.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnosis/experiment/bounds.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion of the menu: what to do on the bench, and its displacement [m] at even steps dt [s].
struct Experiment {
  std::string kind;  ///< "sine", "sweep", ...: motions of a kind differ in their numbers
  std::string description;
  double dt = 0.0;
  Eigen::VectorXd displacement;
  Eigen::Index stride = 1;  ///< one sample in so many is enough to compare models by

  double duration() const { return dt * static_cast<double>(displacement.size() - 1); }
};

/// Sines, sweeps, multisines of odd and of even lines, steps and a hold, triangles, preloads, amplitudes that rise,
/// fall or return, a repeat, motion between standstills, within the bounds. Each can be played as it is: it begins and
/// ends at rest at 0, travels to the centre of the stroke first, and eases in and out. Empty where the bounds leave no
/// room.
std::vector<Experiment> experimentMenu(const Bounds& bounds);

}  // namespace rubber_suspension::diagnosis::experiment
