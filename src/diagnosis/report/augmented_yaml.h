// Writes the component files of a report.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// Returns the style of WrittenLaw::augmented: rounded numbers with intervals as comments. Refers to `diagnosis`.
io::YamlStyle augmentedStyle(const Diagnosis& diagnosis);

/// Returns WrittenLaw::augmented as YAML, with the origin, the gaps and the interval of each number as comments.
std::string augmentedYaml(const Diagnosis& diagnosis);

/// Returns WrittenLaw::full as YAML, with its origin.
std::string fullYaml(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::report
