// The component files of a report, with their origin.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// Returns the style of WrittenLaw::augmented: rounded numbers with intervals as comments. Refers to `diagnosis`.
io::YamlStyle augmentedStyle(const Diagnosis& diagnosis);

/// Returns the text of WrittenLaw::augmented with comments: origin, gaps, interval of each number. Reads back to it.
std::string augmentedYaml(const Diagnosis& diagnosis);

/// Returns the text of WrittenLaw::full, with its origin.
std::string fullYaml(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::report
