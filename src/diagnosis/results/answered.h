// An answer as a diagnosis tells it, be it of logs or of a table: with the names of effects, and with what they close.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/answer.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {

/// Sets verdict and effects, the sets that cannot be told apart, the alternatives and the posterior of a diagnosis.
void addAnswer(const judge::Answer& answer, const judge::Evidence& evidence, Diagnosis& diagnosis);

/// Sets the gap, of which noise is no more than what any of the models leaves, and the fraction of it that the answer
/// closes, with its interval on further logs; and each effect alone, which leaves these errors, the likeliest first.
/// `evidence`: with the errors of what is written. The gap of the full law is known.
void addGap(const Gap& gap, const std::vector<std::vector<gap::PartError>>& alone, const judge::Evidence& evidence,
            const Workings& workings, const DiagnosisOptions& options, Diagnosis& diagnosis);

/// The gap with some of what an answer changes: first whether its values are in, then each of its effects.
using GapWith = std::function<double(const std::vector<bool>& in)>;

/// Sets what values and each effect remove of the gap as configured, and the gap of the values alone; verdict, effects
/// and gap are known.
void addShares(const GapWith& gap_with, int threads, Diagnosis& diagnosis);

/// The component with some of what the augmented one changes.
io::ComponentDescription withSome(const Diagnosis& diagnosis, const std::vector<bool>& in);

/// Sets how far a judged model is from the data sheet, and which of its parameters are at a bound.
void addDepartures(const fit::ModelParameters& model, const Eigen::VectorXd& judged, Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::results
