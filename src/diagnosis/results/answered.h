// An answer with the names of effects.
#pragma once

#include "diagnosis/judge/answer.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Sets verdict and effects, the sets that cannot be told apart, the alternatives and the posterior of a diagnosis.
void addAnswer(const Answer& answer, const Evidence& evidence, Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
