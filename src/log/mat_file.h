// MATLAB files: their structure, checked before libmatio reads them, which takes what is cut off for zeros; matrices as
// such a file.
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

/// Write a file of version 5, beside it and renamed. Throws std::runtime_error with the path that cannot be written.
void writeMatFile(const std::string& path, const std::vector<NamedMatrix>& matrices);

/// Goes through all elements of a file that is no HDF5: their sizes have to add up to those around them and to the
/// file's, their numbers to their dimensions; what is compressed has to have its checksum. Returns the variables that
/// are objects of MATLAB (tables, timetables, timeseries), "name (class)". Throws std::runtime_error that names the
/// byte. `large` as in refuseUnpacked().
std::vector<std::string> checkMatStructure(const std::string& path, bool large);

}  // namespace rubber_suspension::log
