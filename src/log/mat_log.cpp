// Reads a log from a MATLAB file, one at a time: HDF5 beneath is not safe for threads in every build.
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "log/log_columns.h"
#include "log/text.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {
namespace {

using MatPointer = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using VariablePointer = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

// A vector of numbers in the file: a variable, or a field of one.
struct MatColumn {
  std::string name;
  std::string variable;
  std::string field;  // empty: the variable itself
};

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

void addFields(std::vector<MatColumn>& columns, matvar_t& variable) {
  const unsigned count = Mat_VarGetNumberOfFields(&variable);
  char* const* names = Mat_VarGetStructFieldnames(&variable);
  for (unsigned i = 0; i < count; ++i) {
    const matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, i, 0);
    if (field != nullptr && isVector(*field)) {
      columns.push_back({std::string(variable.name) + "." + names[i], variable.name, names[i]});
    }
  }
}

template <class Number>
void copyNumbers(const matvar_t& variable, std::vector<double>& values) {
  const Number* const data = static_cast<const Number*>(variable.data);
  std::transform(data, data + values.size(), values.begin(), [](Number value) { return static_cast<double>(value); });
}

class MatLogReader {
 public:
  MatLogReader(const std::string& path, const LogFormat& format)
      : file_(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close), format_(format) {
    if (!file_) {
      throw std::runtime_error("cannot be read as a MATLAB file; accepted: levels 4 to 7.3");
    }
  }

  Log read() {
    listColumns();
    std::vector<std::string> names;
    std::transform(columns_.begin(), columns_.end(), std::back_inserter(names),
                   [](const MatColumn& column) { return column.name; });
    const Columns columns = findColumns(names, format_);
    Log log;
    log.notes = notesOnIgnored(names, columns, format_);
    log.displacement = readConverted(columns.displacement);
    log.force = readConverted(columns.force);
    log.temperature = readConverted(columns.temperature);
    appendStamps(log, columns.time);
    return log;
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
        columns_.push_back({variable->name, variable->name, ""});
      } else if (variable->class_type == MAT_C_STRUCT && elementCount(*variable) == 1) {
        addFields(columns_, *variable);
      }
    }
    if (variables == 1) {
      for (MatColumn& column : columns_) {
        column.name = column.field.empty() ? column.name : column.field;
      }
    }
  }

  std::vector<double> readConverted(const Column& column) {
    std::vector<double> values = column.found() ? readColumn(column) : std::vector<double>();
    std::transform(values.begin(), values.end(), values.begin(), column.conversion);
    return values;
  }

  std::vector<double> readColumn(const Column& column) {
    const MatColumn& source = columns_[column.index];
    requireSize(source, column);
    const VariablePointer variable(Mat_VarRead(file_.get(), source.variable.c_str()), Mat_VarFree);
    const matvar_t* vector = variable.get();
    if (vector != nullptr && !source.field.empty()) {
      vector = Mat_VarGetStructFieldByName(variable.get(), source.field.c_str(), 0);
    }
    std::vector<double> values = numbersOf(vector, column);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) {
        throw std::runtime_error(
            fmt::format("{}: element {}: {} is not finite; accepted: a finite number", column.name, i + 1, values[i]));
      }
    }
    return values;
  }

  // From what is known before any data is read, so that a small file cannot claim the memory of a large one.
  void requireSize(const MatColumn& source, const Column& column) {
    const VariablePointer info(Mat_VarReadInfo(file_.get(), source.variable.c_str()), Mat_VarFree);
    if (!info) {
      throw std::runtime_error(fmt::format("{}: cannot be read", column.name));
    }
    std::size_t total = elementCount(*info);
    const unsigned fields = info->class_type == MAT_C_STRUCT ? Mat_VarGetNumberOfFields(info.get()) : 0;
    for (unsigned i = 0; i < fields; ++i) {
      const matvar_t* field = Mat_VarGetStructFieldByIndex(info.get(), i, 0);
      total += field == nullptr ? 0 : elementCount(*field);
    }
    if (total > kMaximumLogRows) {
      throw std::runtime_error(
          fmt::format("{}: more than {} numbers; accepted: that many at most", column.name, kMaximumLogRows));
    }
  }

  static std::vector<double> numbersOf(const matvar_t* vector, const Column& column) {
    if (vector == nullptr || vector->data == nullptr || !isVector(*vector)) {
      throw std::runtime_error(fmt::format("{}: cannot be read", column.name));
    }
    if (vector->isComplex != 0) {
      throw std::runtime_error(fmt::format("{}: complex numbers; accepted: real ones", column.name));
    }
    std::vector<double> values(elementCount(*vector));
    switch (vector->data_type) {
      case MAT_T_DOUBLE:
        copyNumbers<double>(*vector, values);
        break;
      case MAT_T_SINGLE:
        copyNumbers<float>(*vector, values);
        break;
      case MAT_T_INT32:
        copyNumbers<std::int32_t>(*vector, values);
        break;
      case MAT_T_INT16:
        copyNumbers<std::int16_t>(*vector, values);
        break;
      case MAT_T_INT64:
        copyNumbers<std::int64_t>(*vector, values);
        break;
      default:
        throw std::runtime_error(fmt::format(
            "{}: numbers of a type that is not read; accepted: double, single, int16 to int64", column.name));
    }
    return values;
  }

  void appendStamps(Log& log, const Column& time) {
    if (format_.rate) {
      for (std::size_t i = 0; i < log.displacement.size(); ++i) {
        log.stamp.push_back(stampAtRate(i, *format_.rate));
      }
      return;
    }
    const std::vector<double> times = readColumn(time);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::int64_t stamp = toStamp(times[i], time);
      try {
        requireIncrease(log.stamp, stamp, time);
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("element {}: {}", i + 1, error.what()));
      }
      log.stamp.push_back(stamp);
    }
  }

  MatPointer file_;
  LogFormat format_;
  std::vector<MatColumn> columns_;
};

}  // namespace

Log readMatLog(const std::string& path, const LogFormat& format) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  try {
    Log log = MatLogReader(path, format).read();
    log.name = logName(path);
    checkLog(log);
    return log;
  } catch (const std::runtime_error& error) {
    throw LogError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace rubber_suspension::log
