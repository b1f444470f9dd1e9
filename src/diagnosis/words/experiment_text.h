// The proposed experiment in words.
#pragma once

#include <string>

#include "diagnosis/experiment/next_experiment.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// What to play next and what it decides; or why nothing, and what it would take. The verdict of the diagnosis is
/// known.
std::string experimentText(const Diagnosis& diagnosis, const experiment::NextExperiment& next);

}  // namespace rubber_suspension::diagnosis::words
