// Reads a log from a MATLAB file. Only one file is read at a time, because libhdf5 is not always thread-safe.
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "element/refuse.h"
#include "log/column_table.h"
#include "log/file_readers.h"
#include "log/hdf5_file.h"
#include "log/log_columns.h"
#include "log/mat_file.h"
#include "log/text.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {
namespace {

using MatPointer = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using VariablePointer = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

// One step of the path to a field: the name of the field and the index of the struct in its array.
struct MatStep {
  std::string field;
  std::size_t element = 0;
};

// A vector of numbers in the file: a variable, a field of a struct, or a row or column of a matrix.
struct MatColumn {
  std::string name;
  std::string unit;  // unit that a text field of the same struct states
  std::string leaf;  // name of the field without its path; empty: `name` applies
  std::string group;
  std::string variable;
  std::vector<MatStep> path;  // path to the field; empty if the variable itself is the vector
  std::size_t part = 0;       // number of the row or column of a matrix, counted from 1; 0 for a vector
};

// A matrix with more rows and columns than this is not a log but, for example, a picture.
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

// Returns true if the channels are the rows, because a log has more samples than channels.
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
    columns.push_back({name, "", "", "", matrix.name, {}, part});
  }
}

std::string textIn(const matvar_t* variable) {
  constexpr std::size_t kLongestText = 200;
  if (variable == nullptr || variable->class_type != MAT_C_CHAR || variable->data == nullptr) {
    return "";
  }
  std::string text;
  const auto* const bytes = static_cast<const unsigned char*>(variable->data);
  const auto size = static_cast<std::size_t>(std::max(variable->data_size, 1));
  for (std::size_t i = 0; i < std::min(elementCount(*variable), kLongestText) && (i + 1) * size <= variable->nbytes;
       ++i) {
    text += bytes[i * size] != 0 ? static_cast<char>(bytes[i * size]) : ' ';
  }
  return trimmed(text);
}

// Returns the text of the field that has one of these names, in upper or lower case; empty if there is none.
std::string textOf(matvar_t& variable, std::size_t element, const std::vector<std::string>& names) {
  char* const* fields = Mat_VarGetStructFieldnames(&variable);
  for (unsigned i = 0; i < Mat_VarGetNumberOfFields(&variable); ++i) {
    if (std::find(names.begin(), names.end(), lowerCase(fields[i])) != names.end()) {
      return textIn(Mat_VarGetStructFieldByIndex(&variable, i, element));
    }
  }
  return "";
}

// Finds the vectors in a struct and in the structs within it. If the struct also contains a text field with a name, as
// written by Simulink and by data acquisition programs, the vector has that name. A field `time` next to a field
// `signals`, as in Simulink's "structure with time", is in seconds.
class FieldFinder {
 public:
  FieldFinder(std::vector<MatColumn>& columns, std::string variable)
      : columns_(columns), variable_(std::move(variable)) {}

  void add(matvar_t& structure, const std::string& name, const std::vector<MatStep>& path) {
    constexpr std::size_t kMostElements = 1000;
    constexpr std::size_t kDeepestPath = 8;
    const std::size_t elements = std::min(elementCount(structure), kMostElements);
    for (std::size_t element = 0; element < elements && path.size() < kDeepestPath; ++element) {
      const std::string place = elements == 1 ? name : fmt::format("{}({})", name, element + 1);
      group_ = path.empty() ? (elements == 1 ? variable_ : fmt::format("{}({})", variable_, element + 1)) : group_;
      addElement(structure, element, place, path);
    }
  }

 private:
  void addElement(matvar_t& structure, std::size_t element, const std::string& place, std::vector<MatStep> path) {
    const std::string label = textOf(structure, element, {"name", "label", "title"});
    const std::string unit = textOf(structure, element, {"unit", "units"});
    const bool with_time = Mat_VarGetStructFieldByName(&structure, "signals", element) != nullptr;
    char* const* names = Mat_VarGetStructFieldnames(&structure);
    for (unsigned i = 0; i < Mat_VarGetNumberOfFields(&structure); ++i) {
      matvar_t* const field = Mat_VarGetStructFieldByIndex(&structure, i, element);
      const std::string name = (place.empty() ? "" : place + ".") + names[i];
      path.push_back({names[i], element});
      if (field != nullptr && field->class_type == MAT_C_STRUCT) {
        add(*field, name, path);
      } else if (field != nullptr && isVector(*field)) {
        const bool labelled = !label.empty() && elementCount(*field) > 1;
        const bool seconds = with_time && unit.empty() && path.back().field == "time";
        columns_.push_back(
            {labelled ? label : name, seconds ? "s" : unit, labelled ? label : names[i], group_, variable_, path, 0});
      }
      path.pop_back();
    }
  }

  std::vector<MatColumn>& columns_;
  std::string variable_;
  std::string group_;
};

template <class Number>
void copyNumbers(const matvar_t& variable, std::size_t first, std::size_t stride, std::vector<double>& values) {
  const Number* const data = static_cast<const Number*>(variable.data);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Number number = data[first + i * stride];
    values[i] = static_cast<double>(number);
    if constexpr (std::is_same_v<Number, std::int64_t>) {
      constexpr std::int64_t kMost = std::int64_t{1} << 53U;
      element::refuseIf<std::runtime_error>(
          number > kMost || number < -kMost,
          "element {}: {} is a whole number beyond 2^53, which a double rounds; accepted: double", i + 1, number);
    }
  }
}

class MatLogReader {
 public:
  MatLogReader(const std::string& path, const LogFormat& format)
      : file_(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close), format_(format) {
    element::refuseIf<std::runtime_error>(!file_, "cannot be read as a MATLAB file; accepted: levels 4 to 7.3");
  }

  std::vector<Log> read(const std::string& name) {
    listColumns();
    ColumnTable table;
    for (const MatColumn& column : columns_) {
      table.names.push_back(parseColumnName(column.name, column.unit));
      table.names.back().bare = parseColumnName(column.leaf.empty() ? column.name : column.leaf).bare;
      table.groups.push_back(column.group);
    }
    table.file = {
        [this](std::size_t place, const std::string& column) { return keep(place, column).size(); },
        [this](std::size_t place, const std::string& column, std::size_t, std::size_t) {  // called once per column
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
    std::vector<std::string> structs;
    while (const VariablePointer variable{Mat_VarReadNextInfo(file_.get()), Mat_VarFree}) {
      ++variables;
      if (variable->name == nullptr) {
        continue;
      }
      if (isVector(*variable)) {
        columns_.push_back({variable->name, "", "", "", variable->name, {}, 0});
      } else if (isMatrix(*variable)) {
        addParts(columns_, *variable);
      } else if (variable->class_type == MAT_C_STRUCT) {
        structs.emplace_back(variable->name);
      } else {
        others_.push_back(fmt::format("{} with {} dimensions", quoted(variable->name), variable->rank));
      }
    }
    element::refuseIf<std::runtime_error>(columns_.empty() && structs.empty(),
                                          "no columns: {}; accepted: vectors, matrices or structs of real numbers",
                                          others_.empty() ? "no variable of MATLAB" + datasets() : join(others_));
    for (const std::string& name : structs) {
      FieldFinder(columns_, name).add(read(name, name), variables == 1 ? "" : name, {});
    }
    for (MatColumn& column : columns_) {
      column.name = variables == 1 && column.part > 0 ? std::to_string(column.part) : column.name;
    }
  }

  // Returns a list of the datasets, for an error, if the file is HDF5 but was not written by MATLAB.
  std::string datasets() const {
    const std::string path = Mat_GetFilename(file_.get());
    if (H5Fis_hdf5(path.c_str()) <= 0) {
      return "";
    }
    const Hdf5Handle file(openHdf5(path), H5Fclose);
    return " (datasets of HDF5: " + describeDatasets(file.get()) + "; with the extension .h5 they are read)";
  }

  // Reads a column when its length is requested, and keeps it until its numbers are requested.
  const std::vector<double>& keep(std::size_t place, const std::string& name) {
    const auto kept = kept_.find(place);
    return kept != kept_.end() ? kept->second : kept_.emplace(place, readColumn(columns_[place], name)).first->second;
  }

  std::vector<double> readColumn(const MatColumn& source, const std::string& name) {
    matvar_t* vector = &read(source.variable, name);
    for (const MatStep& step : source.path) {
      vector = vector == nullptr ? nullptr : Mat_VarGetStructFieldByName(vector, step.field.c_str(), step.element);
    }
    return numbersOf(vector, source.part, name);
  }

  // Returns a variable with its data, which are kept until another variable is read. The size is checked before,
  // because a small file can state any size.
  matvar_t& read(const std::string& variable, const std::string& name) {
    if (kept_variable_ && kept_variable_->name == variable) {
      return *kept_variable_;
    }
    const VariablePointer info(Mat_VarReadInfo(file_.get(), variable.c_str()), Mat_VarFree);
    element::refuseIf<std::runtime_error>(info && numbersIn(*info, 0) > kMaximumLogRows,
                                          "{0}: more than {1} numbers; accepted: at most {1}", name, kMaximumLogRows);
    kept_variable_.reset(info ? Mat_VarRead(file_.get(), variable.c_str()) : nullptr);
    element::refuseIf<std::runtime_error>(!kept_variable_,
                                          "{}: cannot be read; accepted: a vector or a matrix of numbers", name);
    return *kept_variable_;
  }

  static std::size_t numbersIn(matvar_t& variable, std::size_t depth) {
    constexpr std::size_t kDeepestStruct = 64;
    std::size_t total = elementCount(variable);
    const std::size_t fields = variable.class_type == MAT_C_STRUCT && depth < kDeepestStruct && total <= kMaximumLogRows
                                   ? Mat_VarGetNumberOfFields(&variable)
                                   : 0;
    for (std::size_t i = 0; i < fields * elementCount(variable) && total <= kMaximumLogRows; ++i) {
      matvar_t* const field = Mat_VarGetStructFieldByIndex(&variable, i % fields, i / fields);
      total += field == nullptr ? 0 : numbersIn(*field, depth + 1);
    }
    return total;
  }

  static std::vector<double> numbersOf(const matvar_t* vector, std::size_t part, const std::string& name) {
    const bool fits = vector != nullptr && vector->data != nullptr &&
                      (part > 0 ? isMatrix(*vector) : isVector(*vector)) && part <= partCount(*vector);
    element::refuseIf<std::runtime_error>(!fits, "{}: cannot be read; accepted: a vector or a matrix of numbers", name);
    element::refuseIf<std::runtime_error>(vector->isComplex != 0, "{}: complex numbers; accepted: real numbers", name);
    // MATLAB stores column by column.
    const bool wide = part > 0 && isWide(*vector);
    const std::size_t length = part == 0 ? elementCount(*vector) : std::max(vector->dims[0], vector->dims[1]);
    const std::size_t first = part == 0 ? 0 : wide ? part - 1 : (part - 1) * length;
    const std::size_t stride = wide ? vector->dims[0] : 1;
    using Copy = void (*)(const matvar_t&, std::size_t, std::size_t, std::vector<double>&);
    static const std::map<matio_types, Copy> copies = {{MAT_T_DOUBLE, copyNumbers<double>},
                                                       {MAT_T_SINGLE, copyNumbers<float>},
                                                       {MAT_T_INT16, copyNumbers<std::int16_t>},
                                                       {MAT_T_INT32, copyNumbers<std::int32_t>},
                                                       {MAT_T_INT64, copyNumbers<std::int64_t>}};
    const auto copy = copies.find(vector->data_type);
    element::refuseIf<std::runtime_error>(
        copy == copies.end(), "{}: numbers of an unsupported type; accepted: double, single, int16 to int64", name);
    std::vector<double> values(length);
    copy->second(*vector, first, stride, values);
    return values;
  }

  MatPointer file_;
  LogFormat format_;
  VariablePointer kept_variable_{nullptr, Mat_VarFree};
  std::vector<MatColumn> columns_;
  std::vector<std::string> others_;  // variables that cannot be columns
  std::map<std::size_t, std::vector<double>> kept_;
};

}  // namespace

std::vector<Log> readMatLogs(const std::string& path, const LogFormat& format) {
  const std::lock_guard<std::mutex> lock(hdf5Mutex());
  std::string objects;
  try {
    requireOwnData(path);
    objects = join(checkMatStructure(path, format.large));
    return MatLogReader(path, format).read(logName(path));
  } catch (const std::runtime_error& error) {
    throw LogError(fmt::format("{}: {}{}", path, error.what(),
                               objects.empty()
                                   ? ""
                                   : fmt::format("; {} is an object of MATLAB, which is not read: in MATLAB, "
                                                 "writetable(NAME, 'LOG.csv') writes a table, writetimetable(NAME, "
                                                 "'LOG.csv') a timetable",
                                                 objects)));
  }
}

}  // namespace rubber_suspension::log
