// Probabilities of the causes of a gap.
#pragma once

#include <limits>

namespace rubber_suspension::diagnosis {

/// Probabilities of the answers of a diagnosis, which add up to 1; NaN if nothing was judged. Throws nothing.
struct Posterior {
  double none = std::numeric_limits<double>::quiet_NaN();  ///< there is no gap beyond noise
  /// The model's own values are wrong, and nothing is missing.
  double parameter_error = std::numeric_limits<double>::quiet_NaN();
  double effects = std::numeric_limits<double>::quiet_NaN();  ///< of the list are at work; the candidates share it
  double none_of_these = std::numeric_limits<double>::quiet_NaN();  ///< something that is not in the list
};

}  // namespace rubber_suspension::diagnosis
