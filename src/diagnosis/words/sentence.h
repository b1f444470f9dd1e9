// Writes the judgement and the proposed experiment in words.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/experiment/next_experiment.h"
#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Returns the verdict in words for an engineer.
std::string sentence(const Diagnosis& diagnosis);

/// Returns a headline of at most 25 words: what the model lacks, and the reduction of the gap.
std::string headline(const Diagnosis& diagnosis);

/// Returns " Without a recorded temperature ..." if an effect that looks like warming is named for logs without one.
std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation);

/// Returns " Effects excluded by the component file: without this exclusion, the probability of backlash would be
/// 63 %."; empty below 2 %.
std::string excludedNote(const Diagnosis& diagnosis);

/// Returns " The rest depends on the motion ...", depending on how well the surrogate predicts the residual force.
std::string restNote(const Surrogate& surrogate);

/// Returns " Friction differs between the logs: ..." with the factor of each log, or an empty text without factors.
std::string factorNote(const std::vector<double>& factors);

/// Returns the proposed experiment and its purpose, or the reason why there is none and what would be needed. The text
/// depends on the verdict of the diagnosis.
std::string experimentText(const Diagnosis& diagnosis, const experiment::NextExperiment& next);

}  // namespace rubber_suspension::diagnosis::words
