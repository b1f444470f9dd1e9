// Reads a log from a MATLAB file, one at a time: HDF5 beneath is not safe for threads in every build.
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "log/column_table.h"
#include "log/file_readers.h"
#include "log/hdf5_mutex.h"
#include "log/log_columns.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {
namespace {

using MatPointer = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using VariablePointer = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

// A vector of numbers in the file: a variable, a field of one, or a column of a matrix.
struct MatColumn {
  std::string name;
  std::string variable;
  std::string field;     // empty: the variable itself
  std::size_t part = 0;  // of a matrix, from 1; 0: the whole vector
};

// Beyond these a matrix is a picture or a table of something else.
constexpr std::size_t kMostMatrixColumns = 1000;

bool isNumeric(const matvar_t& variable) {
  return variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64;
}

std::size_t elementCount(const matvar_t& variable) {
  std::size_t count = variable.rank > 0 ? 1 : 0;
  for (int i = 0; i < variable.rank; ++i) {
    const bool fits = variable.dims[i] == 0 || count <= kMaximumLogRows / variable.dims[i];
    count = fits ? count * variable.dims[i] : kMaximumLogRows + 1;
  }
  return count;
}

bool isVector(const matvar_t& variable) {
  return isNumeric(variable) && variable.rank == 2 && std::min(variable.dims[0], variable.dims[1]) == 1;
}

// Samples are more than quantities.
bool isWide(const matvar_t& matrix) { return matrix.dims[0] < matrix.dims[1]; }

std::size_t partCount(const matvar_t& matrix) { return std::min(matrix.dims[0], matrix.dims[1]); }

bool isMatrix(const matvar_t& variable) {
  return isNumeric(variable) && variable.rank == 2 && partCount(variable) > 1 &&
         partCount(variable) <= kMostMatrixColumns;
}

void addParts(std::vector<MatColumn>& columns, const matvar_t& matrix) {
  for (std::size_t part = 1; part <= partCount(matrix); ++part) {
    const std::string name =
        isWide(matrix) ? fmt::format("{}({},:)", matrix.name, part) : fmt::format("{}(:,{})", matrix.name, part);
    columns.push_back({name, matrix.name, "", part});
  }
}

void addFields(std::vector<MatColumn>& columns, matvar_t& variable) {
  const unsigned count = Mat_VarGetNumberOfFields(&variable);
  char* const* names = Mat_VarGetStructFieldnames(&variable);
  for (unsigned i = 0; i < count; ++i) {
    const matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, i, 0);
    if (field != nullptr && isVector(*field)) {
      columns.push_back({std::string(variable.name) + "." + names[i], variable.name, names[i], 0});
    }
  }
}

template <class Number>
void copyNumbers(const matvar_t& variable, std::size_t first, std::size_t stride, std::vector<double>& values) {
  const Number* const data = static_cast<const Number*>(variable.data);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<double>(data[first + i * stride]);
  }
}

class MatLogReader {
 public:
  MatLogReader(const std::string& path, const LogFormat& format)
      : file_(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close), format_(format) {
    if (!file_) {
      throw std::runtime_error("cannot be read as a MATLAB file; accepted: levels 4 to 7.3");
    }
  }

  std::vector<Log> read(const std::string& name) {
    listColumns();
    ColumnTable table;
    for (const MatColumn& column : columns_) {
      table.names.push_back(parseColumnName(column.name));
      if (!column.field.empty()) {
        table.names.back().bare = parseColumnName(column.field).bare;
      }
      table.groups.push_back(column.field.empty() ? "" : column.variable);
    }
    table.file = {[this](std::size_t place, const std::string& column) { return keep(place, column).size(); },
         [this](std::size_t place, const std::string& column, std::size_t, std::size_t) {  // once, and all of them
           keep(place, column);
           std::vector<double> numbers = std::move(kept_.at(place));
           kept_.erase(place);
           return numbers;
         }};
    return logsFromColumns(table, format_, name);
  }

 private:
  void listColumns() {
    std::size_t variables = 0;
    while (const VariablePointer variable{Mat_VarReadNextInfo(file_.get()), Mat_VarFree}) {
      ++variables;
      if (variable->name == nullptr) {
        continue;
      }
      if (isVector(*variable)) {
        columns_.push_back({variable->name, variable->name, "", 0});
      } else if (isMatrix(*variable)) {
        addParts(columns_, *variable);
      } else if (variable->class_type == MAT_C_STRUCT && elementCount(*variable) == 1) {
        addFields(columns_, *variable);
      }
    }
    if (variables == 1) {
      for (MatColumn& column : columns_) {
        column.name = column.part > 0 ? std::to_string(column.part) : column.field.empty() ? column.name : column.field;
      }
    }
  }

  // A column whose length was asked for is kept until it is taken.
  const std::vector<double>& keep(std::size_t place, const std::string& name) {
    const auto kept = kept_.find(place);
    return kept != kept_.end() ? kept->second : kept_.emplace(place, readColumn(columns_[place], name)).first->second;
  }

  std::vector<double> readColumn(const MatColumn& source, const std::string& name) {
    requireSize(source, name);
    const VariablePointer variable(Mat_VarRead(file_.get(), source.variable.c_str()), Mat_VarFree);
    const matvar_t* vector = variable.get();
    if (vector != nullptr && !source.field.empty()) {
      vector = Mat_VarGetStructFieldByName(variable.get(), source.field.c_str(), 0);
    }
    return numbersOf(vector, source.part, name);
  }

  // From what is known before any data is read, so that a small file cannot claim the memory of a large one.
  void requireSize(const MatColumn& source, const std::string& name) {
    const VariablePointer info(Mat_VarReadInfo(file_.get(), source.variable.c_str()), Mat_VarFree);
    if (!info) {
      throw std::runtime_error(fmt::format("{}: cannot be read; accepted: a vector or a matrix of numbers", name));
    }
    std::size_t total = elementCount(*info);
    const unsigned fields = info->class_type == MAT_C_STRUCT ? Mat_VarGetNumberOfFields(info.get()) : 0;
    for (unsigned i = 0; i < fields; ++i) {
      const matvar_t* field = Mat_VarGetStructFieldByIndex(info.get(), i, 0);
      total += field == nullptr ? 0 : elementCount(*field);
    }
    if (total > kMaximumLogRows) {
      throw std::runtime_error(
          fmt::format("{}: more than {} numbers; accepted: that many at most", name, kMaximumLogRows));
    }
  }

  static std::vector<double> numbersOf(const matvar_t* vector, std::size_t part, const std::string& name) {
    const bool fits = vector != nullptr && vector->data != nullptr &&
                      (part > 0 ? isMatrix(*vector) : isVector(*vector)) && part <= partCount(*vector);
    if (!fits) {
      throw std::runtime_error(fmt::format("{}: cannot be read; accepted: a vector or a matrix of numbers", name));
    }
    if (vector->isComplex != 0) {
      throw std::runtime_error(fmt::format("{}: complex numbers; accepted: real ones", name));
    }
    // MATLAB stores column by column.
    const bool wide = part > 0 && isWide(*vector);
    const std::size_t length = part == 0 ? elementCount(*vector) : std::max(vector->dims[0], vector->dims[1]);
    const std::size_t first = part == 0 ? 0 : wide ? part - 1 : (part - 1) * length;
    const std::size_t stride = wide ? vector->dims[0] : 1;
    std::vector<double> values(length);
    switch (vector->data_type) {
      case MAT_T_DOUBLE:
        copyNumbers<double>(*vector, first, stride, values);
        break;
      case MAT_T_SINGLE:
        copyNumbers<float>(*vector, first, stride, values);
        break;
      case MAT_T_INT32:
        copyNumbers<std::int32_t>(*vector, first, stride, values);
        break;
      case MAT_T_INT16:
        copyNumbers<std::int16_t>(*vector, first, stride, values);
        break;
      case MAT_T_INT64:
        copyNumbers<std::int64_t>(*vector, first, stride, values);
        break;
      default:
        throw std::runtime_error(
            fmt::format("{}: numbers of a type that is not read; accepted: double, single, int16 to int64", name));
    }
    return values;
  }

  MatPointer file_;
  LogFormat format_;
  std::vector<MatColumn> columns_;
  std::map<std::size_t, std::vector<double>> kept_;
};

}  // namespace

std::vector<Log> readMatLogs(const std::string& path, const LogFormat& format) {
  const std::lock_guard<std::mutex> lock(hdf5Mutex());
  try {
    return MatLogReader(path, format).read(logName(path));
  } catch (const std::runtime_error& error) {
    throw LogError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace rubber_suspension::log
