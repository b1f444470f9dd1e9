// Prior of the displacement's zero in each log, before any fit.
#pragma once

#include <vector>

#include "fit/free_in_log.h"

namespace rubber_suspension::fit {

/// Zeros of the displacement that records may have: those of the logs of the fit, and of unseen ones.
struct ZeroPriors {
  std::vector<DisplacementZero> training;
  std::vector<DisplacementZero> held_out;
};

}  // namespace rubber_suspension::fit
