// Probabilities of the possible answers of a diagnosis.
#pragma once

#include <limits>

namespace rubber_suspension::diagnosis {

/// Probabilities of the answers of a diagnosis, which add up to 1; NaN if nothing was judged. Throws nothing.
struct Posterior {
  double none = std::numeric_limits<double>::quiet_NaN();  ///< no gap beyond noise
  /// The model's own values are wrong, and no effect is missing.
  double parameter_error = std::numeric_limits<double>::quiet_NaN();
  double effects = std::numeric_limits<double>::quiet_NaN();  ///< listed effects are at work; sum over all sets of them
  double none_of_these = std::numeric_limits<double>::quiet_NaN();  ///< an unlisted cause alone
};

}  // namespace rubber_suspension::diagnosis
