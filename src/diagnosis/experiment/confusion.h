// Predicts how effects that are added to the logs would be judged.
#pragma once

#include "diagnosis/hypotheses/implant.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/could_show.h"

namespace rubber_suspension::diagnosis::experiment {

/// Returns the evidence for an added effect of this size (its RMS force divided by the standard deviation of the
/// force), on logs that otherwise agree with the model.
judge::Evidence evidenceOf(const hypotheses::Search& search, const hypotheses::Implant& implant, double size);

/// Returns the judgement of all added effects of a search at this size; `why` explains how the size was chosen.
CouldShow couldShow(const hypotheses::Search& search, double size, const std::string& why);

/// Returns the judgement at a third of the gap above the noise or, if this is below the noise floor or the gap that an
/// engineer accepts, at 10 % of the force.
CouldShow couldShow(const hypotheses::Search& search);

}  // namespace rubber_suspension::diagnosis::experiment
