// Probabilities of the possible answers of a diagnosis.
#pragma once

#include <limits>

namespace rubber_suspension::diagnosis {

/// Probabilities of the answers of a diagnosis, which add up to 1; NaN if nothing was judged. Throws nothing.
struct Posterior {
  double none = std::numeric_limits<double>::quiet_NaN();  ///< no gap beyond noise
  /// The model's own values are wrong, and no effect is missing.
  double parameter_error = std::numeric_limits<double>::quiet_NaN();
  /// effects of the list are at work; the sum over all sets
  double effects = std::numeric_limits<double>::quiet_NaN();
  /// a cause that is not in the list, without effects of the list
  double none_of_these = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace rubber_suspension::diagnosis
