// The component that a diagnosis writes: the simplest law of each named effect, rounded, and its errors.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/replayed.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The written component of a judged hypothesis, and its errors.
struct MeasuredLaw {
  WrittenLaw law;
  Replayed errors;
  FittedLaw fitted;            ///< the law before rounding
  bool as_configured = false;  ///< no value was fitted
};

/// Simplifies and rounds the law of a judged hypothesis. `before`: gap of the re-estimated model.
MeasuredLaw writtenLaw(const hypotheses::PreparedCase& prepared, const hypotheses::Search& search,
                       const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options);

/// Returns the written numbers with their texts in the unit of the configured file: exact if the number is as
/// configured, otherwise rounded to a tenth of half its interval and `finer` digits finer.
std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer);

/// Returns the component that a file with these texts describes. Throws std::invalid_argument if a number is out of its
/// range.
io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written);

}  // namespace rubber_suspension::diagnosis::results
