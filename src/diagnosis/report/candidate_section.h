// Which effects were weighed, what the probabilities mean, and why a candidate is out.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// HTML: the candidates of 1 % and more or named, the others folded with the reason.
std::string candidateSection(const Diagnosis& diagnosis);

/// Why a candidate is not named, in half a sentence; empty where it is.
std::string whyOut(const Diagnosis& diagnosis, const CandidateResult& candidate);

}  // namespace rubber_suspension::diagnosis
