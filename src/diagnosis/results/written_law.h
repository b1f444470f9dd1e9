// The component that a diagnosis writes: the simplest law of what it named, rounded; and what it comes to.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/replayed.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The component of a hypothesis that was judged, as it is written, and the errors of that component.
struct MeasuredLaw {
  WrittenLaw law;
  Replayed errors;
  FittedLaw fitted;            ///< the same before it was rounded
  bool as_configured = false;  ///< nothing was fitted of it
};

/// `before`: gap of the re-estimated model.
MeasuredLaw writtenLaw(const hypotheses::PreparedCase& prepared, const hypotheses::Search& search,
                       const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options);

/// The written numbers of a component with their text: those as configured exactly, each other rounded to a tenth of
/// half its interval in the unit of the configured file, and `finer` digits finer.
std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer);

/// The component that a file with these texts describes. Throws std::invalid_argument where the numbers are no
/// component.
io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written);

}  // namespace rubber_suspension::diagnosis::results
