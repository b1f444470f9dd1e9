// Computes the component that a diagnosis writes, with the simplest law of each named effect, and its errors.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/replayed.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

struct MeasuredLaw {
  WrittenLaw law;
  Replayed errors;
  FittedLaw fitted;            ///< the law before rounding
  bool as_configured = false;  ///< no value was fitted
};

/// Simplifies and rounds the law of a judged hypothesis. `before` is the gap of the re-estimated model.
MeasuredLaw writtenLaw(const hypotheses::PreparedCase& prepared, const hypotheses::Search& search,
                       const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options);

/// Returns the written numbers with texts in the units of the configured file. The text of a number that equals the
/// configured number is exact. Other numbers are rounded to a tenth of half their interval, or with `finer` more
/// digits.
std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer);

/// Returns the component in a file with these texts. Throws std::invalid_argument if a number is out of its range.
io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written);

}  // namespace rubber_suspension::diagnosis::results
