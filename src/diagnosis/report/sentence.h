// The judgement in words.
#pragma once

#include <string>

#include "diagnosis/judge/judge.h"
#include "diagnosis/report/experiment.h"
#include "diagnosis/search.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Judgement& judgement, const Diagnosis& diagnosis);

/// An experiment in words, and what to play.
struct NextExperiment {
  std::string text;
  ProposedExperiment proposed;
};

/// The experiment that would best tell two explanations apart: the one judged and the best that is not in it. `stroke`:
/// where the logs moved.
NextExperiment nextExperiment(const Search& search, const Judgement& judgement, const fit::ModelParameters& model,
                              const Stroke& stroke);

}  // namespace rubber_suspension::diagnosis
