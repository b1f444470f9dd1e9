// Checks the structure of a MATLAB file of level 4 or 5 before libmatio reads it, which takes what is cut off for
// zeros.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::log {

/// Goes through all elements of a file that is no HDF5: their sizes have to add up to those around them and to the
/// file's, their numbers to their dimensions; what is compressed has to have its checksum. Returns the variables that
/// are objects of MATLAB (tables, timetables, timeseries), "name (class)". Throws std::runtime_error that names the
/// byte.
std::vector<std::string> checkMatStructure(const std::string& path);

}  // namespace rubber_suspension::log
