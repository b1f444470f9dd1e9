// Matrices as a MATLAB file.
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

}  // namespace rubber_suspension::log
