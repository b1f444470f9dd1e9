// The judgement in words.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
