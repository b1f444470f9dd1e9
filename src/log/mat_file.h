// Writes matrices to MATLAB files, and checks such files before libmatio, which reads missing data as zeros.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::log {

struct NamedMatrix {
  std::string name;
  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;  ///< in column-major order
};

/// Writes a file of level 5 under a temporary name and then renames it. Throws std::runtime_error with the path.
void writeMatFile(const std::string& path, const std::vector<NamedMatrix>& matrices);

/// Checks all elements of a file of level 4 or 5: each must fit into its parent element and the file, have as many
/// numbers as its dimensions require and, if compressed, have a valid checksum. Returns "name (class)" for each
/// variable that is an object of MATLAB (table, timetable, timeseries). Throws std::runtime_error that states the
/// position. `large` has the meaning that it has in refuseUnpacked().
std::vector<std::string> checkMatStructure(const std::string& path, bool large);

}  // namespace rubber_suspension::log
