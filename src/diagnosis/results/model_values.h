// The model's own values: which of them the logs contradict, and in what words.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Values of the model that differ from the component file by 2 % or more with an interval that leaves the configured
/// one out; the farthest off first.
std::vector<const SizedValue*> changedValues(const Diagnosis& diagnosis);

/// "K_n is 19 % too low in the component file (3.4 kN/mm instead of 4.2 kN/mm)".
std::string offText(const SizedValue& size);

/// The same where effects are added, which take over part of what the value stood for: "K_n becomes 3.4 kN/mm (4.2
/// kN/mm in the component file)".
std::string besideText(const SizedValue& size);

/// The component file before and after: values that differ, and entries added. HTML.
std::string componentChanges(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
