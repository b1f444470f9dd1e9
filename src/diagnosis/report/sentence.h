// The judgement in words.
#pragma once

#include <string>

#include "diagnosis/judge/judge.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Judgement& judgement, const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
