// Map of the force that a model lacks, over displacement and velocity.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis::results {

/// Means over cells of displacement and velocity, all logs together.
struct MissingForce {
  std::vector<double> displacement;  ///< edges of the cells [m]
  std::vector<double> velocity;      ///< edges [m/s]
  /// Cells row by row along the velocity; where there are too few samples not a number.
  std::vector<double> measured;   ///< measured less augmented force [N]
  std::vector<double> surrogate;  ///< what the surrogate adds to the augmented force [N]
  std::vector<int> samples;
};

/// Of a diagnosis with a surrogate. Samples that did not count in the fit do not count here.
MissingForce missingForce(const Diagnosis& diagnosis);

/// The cells that have samples: a line each.
std::string toCsv(const MissingForce& map);

/// Two maps: what is missing, and what the surrogate makes of it.
io::Figure missingForceFigure(const MissingForce& map);

}  // namespace rubber_suspension::diagnosis::results
