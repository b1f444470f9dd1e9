// The menu of motions that an experiment may consist of.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnosis/experiment/bounds.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion of the menu: its description for the bench, and its displacement [m] at time steps dt [s].
struct Experiment {
  std::string kind;  ///< "sine", "sweep", ...; motions of a kind differ in their numbers
  std::string description;
  double dt = 0.0;
  Eigen::VectorXd displacement;
  Eigen::Index stride = 1;  ///< every stride-th sample suffices to compare models

  double duration() const { return dt * static_cast<double>(displacement.size() - 1); }
};

/// Returns motions within the bounds: sines, sweeps, multisines of odd and of even lines, steps and a hold, triangles,
/// preloads, amplitudes that rise, fall or return, a repeat, and motion between standstills. Each begins and ends at
/// rest at 0, travels to the centre of the stroke first, and eases in and out. Empty if the bounds are too narrow.
std::vector<Experiment> experimentMenu(const Bounds& bounds);

}  // namespace rubber_suspension::diagnosis::experiment
