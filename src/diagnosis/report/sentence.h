// The judgement in words.
#pragma once

#include <string>

#include "diagnosis/judge/judge.h"
#include "diagnosis/search.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Judgement& judgement, const Diagnosis& diagnosis);

/// The experiment that would best tell two explanations apart: the one judged and the best that is not in it.
std::string nextExperiment(const Search& search, const Judgement& judgement, const fit::ModelParameters& model);

}  // namespace rubber_suspension::diagnosis
