// Which experiment would tell two explanations of the same logs apart.
#pragma once

#include <string>
#include <vector>

#include "fit/excitation.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis {

/// An experiment of the menu: what to do on the bench, and its displacement [m] at even steps dt [s].
struct Experiment {
  std::string description;
  double dt = 0.0;
  Eigen::VectorXd displacement;
};

/// Where the logs moved: about `centre`, by `half` to either side [m].
struct Stroke {
  double centre = 0.0;
  double half = 0.0;
};

/// Of displacements from `low` to `high`. Where that is nearly symmetric, the centre is 0 and the smaller side counts.
Stroke strokeOf(double low, double high);

/// Sines over frequency and amplitude, a hold, a preload, and small amplitude before and after a large one, within the
/// displacements, frequencies and rates that the logs show to be possible. Each can be played as it is: it begins and
/// ends at rest at 0, travels to the centre of the stroke first, and eases its amplitude in and out over a cycle.
std::vector<Experiment> experimentMenu(const fit::Excitation& excitation, const Stroke& stroke);

/// The experiment in which two models differ most.
struct Discrimination {
  const Experiment* experiment = nullptr;
  double difference = 0.0;  ///< RMS difference of the two forces in units of the noise floor
};

/// `noise` is the floor in force [N].
Discrimination mostTelling(const std::vector<Experiment>& menu, const std::vector<element::ElementDescription>& one,
                           const std::vector<element::ElementDescription>& other, double noise);

}  // namespace rubber_suspension::diagnosis
