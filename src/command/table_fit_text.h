// Checks of tables for `estimate --from-table`, and the text on a fit.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// Throws std::runtime_error if the table has temperatures and an element of the component shifts with them, because a
/// fit only identifies the shift of the key `temperature`. `source` is the name of the file.
void requireNoShift(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                    const std::string& source);

/// Throws std::runtime_error if all loss angles are negative or, unless units are accepted, the stiffness is off by
/// hundreds. Smaller factors may be real and are returned as notes.
std::vector<std::string> checkBenchOfTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                                           const std::string& source);

std::string toText(const fit::TableFit& fit, const fit::MeasuredTable& table);

}  // namespace rubber_suspension::command
