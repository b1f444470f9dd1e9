// The numbers of the component file that a diagnosis writes, rounded to what is known of them.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The written numbers of a component with their text: those as configured exactly, each other rounded to a tenth of
/// half its interval in the unit of the configured file, and `finer` digits finer.
std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer);

/// Writes each of these numbers as its text has it. Refers to them.
io::YamlStyle styleOf(const std::vector<SizedValue>& written);

/// The component as the file of that style reads back. Throws std::runtime_error where the numbers are no component.
io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written);

}  // namespace rubber_suspension::diagnosis::results
