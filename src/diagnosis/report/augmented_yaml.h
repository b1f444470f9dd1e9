// The component files of a report, with their origin.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// Style of WrittenLaw::augmented: each number as rounded, with its interval as a comment. Refers to the diagnosis.
io::YamlStyle augmentedStyle(const Diagnosis& diagnosis);

/// Text of WrittenLaw::augmented, which reads back to it, with comments: origin, gaps, interval of each number.
std::string augmentedYaml(const Diagnosis& diagnosis);

/// Text of WrittenLaw::full, with its origin.
std::string fullYaml(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::report
