// Ratings of logs by ISO/TS 18571.
#include "diagnosis/report/log_rating.h"

#include "diagnosis/hypotheses/workings.h"
#include "fit/parallel.h"

namespace rubber_suspension::diagnosis::report {

std::vector<LogRating> logRatings(const Diagnosis& diagnosis) {
  const bool judged = diagnosis.workings && diagnosis.workings->force_augmented.size() == diagnosis.admission.size();
  std::vector<LogRating> ratings(judged ? diagnosis.admission.size() : 0);
  fit::parallelFor(ratings.size(), DiagnosisOptions().threads, [&](std::size_t r) {
    const Workings& w = *diagnosis.workings;
    ratings[r] = {gap::rateIso18571(w.records[r].force, w.force_configured[r]),
                  gap::rateIso18571(w.records[r].force, w.force_augmented[r])};
  });
  return ratings;
}

}  // namespace rubber_suspension::diagnosis::report
