// Confusion of effects: implanted effects before the judge.
#pragma once

#include "diagnosis/hypotheses/implant.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/could_show.h"

namespace rubber_suspension::diagnosis::experiment {

/// The evidence that an implant of this size would be, on logs that otherwise agree with the model.
judge::Evidence evidenceOf(const hypotheses::Search& search, const hypotheses::Implant& implant, double size);

/// The table of all implants of a search at a size (a gap), judged as logs are.
CouldShow couldShow(const hypotheses::Search& search, double size, const std::string& why);

/// Judges effects at a third of the gap above the noise; without a gap, at 10 % of the force.
CouldShow couldShow(const hypotheses::Search& search);

}  // namespace rubber_suspension::diagnosis::experiment
