// MATLAB files: checks of their structure before libmatio reads them, because it reads missing data as zeros, and
// writing of matrices.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::log {

struct NamedMatrix {
  std::string name;
  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;  ///< column by column
};

/// Writes a file of level 5 under a temporary name and renames it. Throws std::runtime_error with the path.
void writeMatFile(const std::string& path, const std::vector<NamedMatrix>& matrices);

/// Checks all elements of a file of level 4 or 5: their sizes have to agree with the elements around them and the file,
/// their numbers with their dimensions, and compressed data with their checksums. Returns the variables that are
/// objects of MATLAB (tables, timetables, timeseries), "name (class)". Throws std::runtime_error that names the byte.
/// `large` as in refuseUnpacked().
std::vector<std::string> checkMatStructure(const std::string& path, bool large);

}  // namespace rubber_suspension::log
