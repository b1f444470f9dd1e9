// Checks tables for `estimate --from-table`, and describes the fit to a table as text.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// Throws std::runtime_error if the table has temperatures and an element of the component depends on temperature,
/// because the fit can identify the dependence under the key `temperature` only. `source` is the name of the file.
void requireNoShift(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                    const std::string& source);

/// Throws std::runtime_error if all loss angles are negative, or if the stiffness is wrong by a factor of hundreds and
/// the user has not confirmed the units. Smaller factors may be real and are returned as notes.
std::vector<std::string> checkBenchOfTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                                           const std::string& source);

std::string toText(const fit::TableFit& fit, const fit::MeasuredTable& table);

}  // namespace rubber_suspension::command
