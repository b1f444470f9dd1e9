// The rating of each log of a diagnosis by ISO/TS 18571, before and after.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/iso18571.h"

namespace rubber_suspension::diagnosis::report {

/// Of the log as recorded, at even time steps.
struct LogRating {
  gap::Iso18571 as_configured;
  gap::Iso18571 augmented;
};

/// One for each entry of the admission; none where no log was judged.
std::vector<LogRating> logRatings(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::report
