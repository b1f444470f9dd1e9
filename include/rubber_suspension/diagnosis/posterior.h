// Probabilities of what a gap comes of.
#pragma once

namespace rubber_suspension::diagnosis {

/// Of the answers that a diagnosis can give; they add up to 1. Throws nothing.
struct Posterior {
  double none = 0.0;             ///< there is no gap beyond noise
  double parameter_error = 0.0;  ///< the model's own values are wrong, and nothing is missing
  double effects = 0.0;          ///< effects of the list are at work; the candidates share it
  double none_of_these = 0.0;    ///< something that is not in the list
};

}  // namespace rubber_suspension::diagnosis
