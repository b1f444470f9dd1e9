// Tables that `estimate --from-table` refuses to fit, and its text on a fit.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// Throws std::runtime_error where the table has temperatures and elements of the component shift with them: a fit
/// finds the shift of the key `temperature` alone. `source`: the name of the file.
void requireNoShift(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                    const std::string& source);

/// Throws std::runtime_error for a table that cannot be what it says: all loss angles negative, or a stiffness off by
/// hundreds, unless its units are accepted. Smaller factors may be what is sought: notes that name them.
std::vector<std::string> checkBenchOfTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                                           const std::string& source);

std::string toText(const fit::TableFit& fit, const fit::MeasuredTable& table);

}  // namespace rubber_suspension::command
