// The judgement and the proposed experiment in words.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/experiment/next_experiment.h"
#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Diagnosis& diagnosis);

/// Headline of at most 25 words: what the model lacks, and the reduction of the gap.
std::string headline(const Diagnosis& diagnosis);

/// " Without a recorded temperature ...", for logs without one that name softening or heating; empty for all others.
std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation);

/// " Excluded by the component file; without that, backlash would be 63 %.", for what would be 2 % or more; else empty.
std::string excludedNote(const Diagnosis& diagnosis);

/// " The rest is a function of the motion ...", for a rest that a surrogate was fitted to.
std::string restNote(const Surrogate& surrogate);

/// " Friction differs between the logs, ...", from the factor on it in each log; empty where there are none.
std::string factorNote(const std::vector<double>& factors);

/// Proposed experiment and its purpose; or the reason for none, and what would be needed. Needs the verdict of the
/// diagnosis.
std::string experimentText(const Diagnosis& diagnosis, const experiment::NextExperiment& next);

}  // namespace rubber_suspension::diagnosis::words
