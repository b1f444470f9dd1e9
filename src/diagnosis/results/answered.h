// An answer as a diagnosis tells it, be it of logs or of a table: with the names of effects, and with what they close.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/judge/answer.h"
#include "diagnosis/results/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Sets verdict and effects, the sets that cannot be told apart, the alternatives and the posterior of a diagnosis.
void addAnswer(const Answer& answer, const Evidence& evidence, Diagnosis& diagnosis);

/// Sets the fraction of the gap that the answer closes, with its interval on further logs. The gap is known.
void addClosed(const Workings& workings, const DiagnosisOptions& options, Diagnosis& diagnosis);

/// An effect alone, which leaves this gap. What the answer closes is known.
CandidateResult candidateResult(const Workings& workings, const DiagnosisOptions& options, const Diagnosis& diagnosis,
                                std::size_t candidate, double gap);

/// The likeliest first.
void sortByProbability(std::vector<CandidateResult>& candidates);

}  // namespace rubber_suspension::diagnosis
