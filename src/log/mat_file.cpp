// Matrices as a MATLAB file, by matio.
#include "log/mat_file.h"

#include <matio.h>

#include <memory>
#include <stdexcept>

#include "log/new_file.h"

namespace rubber_suspension::log {
namespace {

void writeMatrix(mat_t* file, const NamedMatrix& matrix, const std::string& path) {
  std::size_t sizes[] = {matrix.rows, matrix.columns};
  std::vector<double> values = matrix.values;
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(
      Mat_VarCreate(matrix.name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, values.data(), 0), Mat_VarFree);
  if (!variable || Mat_VarWrite(file, variable.get(), MAT_COMPRESSION_NONE) != 0) {
    throw std::runtime_error(path + ": " + matrix.name + " cannot be written");
  }
}

}  // namespace

void writeMatFile(const std::string& path, const std::vector<NamedMatrix>& matrices) {
  NewFile file(path);
  {
    const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(
        Mat_CreateVer(file.writingPath().c_str(), "rubber_suspension", MAT_FT_MAT5), Mat_Close);
    if (!mat) {
      throw std::runtime_error(path + ": cannot be written");
    }
    for (const NamedMatrix& matrix : matrices) {
      writeMatrix(mat.get(), matrix, path);
    }
  }
  file.commit();
}

}  // namespace rubber_suspension::log
