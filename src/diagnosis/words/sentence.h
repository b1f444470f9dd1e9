// The judgement in words.
#pragma once

#include <string>
#include <vector>

#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// The verdict for an engineer, from the numbers and names of a diagnosis.
std::string sentence(const Diagnosis& diagnosis);

/// A sentence for logs without a temperature that name softening or heating; empty for all others.
std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation);

}  // namespace rubber_suspension::diagnosis::words
