// The component file that a diagnosis writes: numbers rounded to what is known of them, with their origin.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The component as its file reads back: each of the `written` numbers that is not as configured rounded to a tenth of
/// half its interval in the unit of the configured file, and `finer` digits finer. Throws std::runtime_error where the
/// rounded numbers are no component.
io::ComponentDescription rounded(const io::ComponentDescription& exact, const std::vector<SizedValue>& written,
                                 int finer);

/// How it is written: each number as rounded() has it, its interval as a comment. Refers to the diagnosis.
io::YamlStyle augmentedStyle(const Diagnosis& diagnosis);

/// Text of Diagnosis::augmented, which reads back to it, with comments: origin, gaps, interval of each number.
std::string augmentedYaml(const Diagnosis& diagnosis);

/// Text of Diagnosis::augmented_full, with its origin.
std::string fullYaml(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::results
