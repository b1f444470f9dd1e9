// The motions among which the next experiment is selected.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnosis/experiment/bounds.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion of the menu: its description for the operator of the bench, and its displacement [m] at time steps dt [s].
struct Experiment {
  std::string kind;  ///< "sine", "sweep", ...; motions of one kind differ in numbers only
  std::string description;
  double dt = 0.0;
  Eigen::VectorXd displacement;
  Eigen::Index stride = 1;  ///< a comparison of models needs every stride-th sample only

  double duration() const { return dt * static_cast<double>(displacement.size() - 1); }
};

/// Returns motions within the bounds: sines, sweeps, multisines, steps and a hold, triangles, preloads, amplitudes that
/// rise, fall or return, a repetition, and a motion between two rests. Each starts and ends smoothly at rest at
/// displacement 0, and moves to the centre of the stroke first. Returns an empty list if the bounds are too narrow.
std::vector<Experiment> experimentMenu(const Bounds& bounds);

}  // namespace rubber_suspension::diagnosis::experiment
