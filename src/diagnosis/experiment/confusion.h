// Confusion of effects: the judgement of implanted effects.
#pragma once

#include "diagnosis/hypotheses/implant.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/could_show.h"

namespace rubber_suspension::diagnosis::experiment {

/// Returns the evidence for an implant of a size (a gap), on logs that otherwise agree with the model.
judge::Evidence evidenceOf(const hypotheses::Search& search, const hypotheses::Implant& implant, double size);

/// Returns the judgement of all implants of a search at a size (a gap).
CouldShow couldShow(const hypotheses::Search& search, double size, const std::string& why);

/// Judges implants at a third of the gap above the noise or, if there is hardly any gap, at 10 % of the force.
CouldShow couldShow(const hypotheses::Search& search);

}  // namespace rubber_suspension::diagnosis::experiment
