// Reads a log from an HDF5 file. Only one file is read at a time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "log/column_table.h"
#include "log/file_readers.h"
#include "log/hdf5_file.h"
#include "log/log_columns.h"

namespace rubber_suspension::log {
namespace {

constexpr hsize_t kMostColumns = 10000;  // limit for a file and for a matrix

// A column of numbers: a dataset, a member of a compound dataset, or a row or column of a matrix.
struct Hdf5Column {
  std::string name;
  std::string path;
  std::string member;  // name of the member of a compound dataset
  std::string unit;
  hsize_t length = 0;
  hsize_t parts = 1;
  hsize_t part = 0;
  bool wide = false;  // true if the channels are the rows of the matrix
  int rank = 1;
  bool is_long = false;  // true if the numbers are 8-byte integers
};

std::string textAttribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) {
    return {};
  }
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(attribute ? H5Aget_type(attribute.get()) : -1, H5Tclose);
  const Hdf5Handle space(attribute ? H5Aget_space(attribute.get()) : -1, H5Sclose);
  if (!type || !space || H5Tget_class(type.get()) != H5T_STRING || H5Sget_simple_extent_npoints(space.get()) != 1) {
    return {};
  }
  if (H5Tis_variable_str(type.get()) > 0) {
    char* text = nullptr;
    const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(memory.get(), H5T_VARIABLE);
    H5Tset_cset(memory.get(), H5Tget_cset(type.get()));
    std::string result = H5Aread(attribute.get(), memory.get(), &text) >= 0 && text != nullptr ? text : "";
    H5free_memory(text);
    return result;
  }
  constexpr std::size_t kLongest = 256;
  const std::size_t size = H5Tget_size(type.get());
  if (size == 0 || size > kLongest) {
    return {};
  }
  std::string result(size, '\0');
  result = H5Aread(attribute.get(), type.get(), result.data()) >= 0 ? result : std::string();
  return result.substr(0, result.find('\0'));
}

std::string unitOf(hid_t dataset) {
  for (const char* name : {"unit", "units", "Unit", "Units"}) {
    const std::string text = textAttribute(dataset, name);
    if (const auto unit = unitInField(text); unit && !unit->empty()) {
      return *unit;
    }
  }
  return {};
}

bool isNumber(H5T_class_t kind) { return kind == H5T_INTEGER || kind == H5T_FLOAT; }

bool isLong(hid_t type) { return H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) == sizeof(std::int64_t); }

// Returns the names of the numeric members of a compound dataset.
std::vector<std::string> memberNames(hid_t type) {
  std::vector<std::string> names;
  const int count = H5Tget_nmembers(type);
  for (unsigned i = 0; static_cast<int>(i) < count; ++i) {
    char* const name = H5Tget_member_name(type, i);
    if (name != nullptr && isNumber(H5Tget_member_class(type, i))) {
      names.emplace_back(name);
    }
    H5free_memory(name);
  }
  return names;
}

std::vector<hsize_t> extentOf(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = space ? H5Sget_simple_extent_ndims(space.get()) : -1;
  std::vector<hsize_t> extent(rank == 1 || rank == 2 ? static_cast<std::size_t>(rank) : 0);
  if (!extent.empty()) {
    H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
  }
  return extent;
}

void addDataset(std::vector<Hdf5Column>& columns, hid_t dataset, const std::string& path) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = type ? H5Tget_class(type.get()) : H5T_NO_CLASS;
  const std::vector<hsize_t> extent = extentOf(dataset);
  if (extent.empty() || !(isNumber(kind) || (kind == H5T_COMPOUND && extent.size() == 1))) {
    return;
  }
  Hdf5Column column;
  column.path = path;
  column.unit = unitOf(dataset);
  column.rank = static_cast<int>(extent.size());
  column.length = *std::max_element(extent.begin(), extent.end());
  if (kind == H5T_COMPOUND) {
    for (std::string& member : memberNames(type.get())) {
      column.member = std::move(member);
      const int place = H5Tget_member_index(type.get(), column.member.c_str());
      column.is_long = isLong(Hdf5Handle(H5Tget_member_type(type.get(), static_cast<unsigned>(place)), H5Tclose).get());
      columns.push_back(column);
    }
    return;
  }
  column.is_long = isLong(type.get());
  column.parts = extent.size() == 2 ? std::min(extent[0], extent[1]) : 1;
  column.wide = extent.size() == 2 && extent[0] < extent[1];
  for (column.part = 0; column.part < std::min(column.parts, kMostColumns); ++column.part) {
    columns.push_back(column);
  }
}

std::string leafOf(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

// Returns the group of a column. A compound dataset is itself the group of its members.
std::string folderOf(const Hdf5Column& column) { return column.member.empty() ? groupOf(column.path) : column.path; }

// Names the columns by their paths, or without the path if all columns are in the same group.
void nameColumns(std::vector<Hdf5Column>& columns) {
  std::set<std::string> groups;
  std::set<std::string> paths;
  for (const Hdf5Column& column : columns) {
    groups.insert(folderOf(column));
    paths.insert(column.path);
  }
  for (Hdf5Column& column : columns) {
    const std::string path = column.path + (column.member.empty() ? "" : "/" + column.member);
    const std::string name = groups.size() == 1 ? leafOf(path) : path;
    const std::string number = std::to_string(column.part + 1);
    column.name = column.parts == 1   ? name
                  : paths.size() == 1 ? number
                  : column.wide       ? name + "[" + number + ",:]"
                                      : name + "[:," + number + "]";
  }
}

// Returns the HDF5 type in memory: `number`, or a structure that contains it as the member of the column.
hid_t memoryType(const Hdf5Column& column, hid_t number) {
  if (column.member.empty()) {
    return H5Tcopy(number);
  }
  const hid_t type = H5Tcreate(H5T_COMPOUND, H5Tget_size(number));
  H5Tinsert(type, column.member.c_str(), 0, number);
  return type;
}

// Reads the numbers [first, first + count) of a column. `number` is the HDF5 type in memory.
template <class Number>
std::vector<Number> readAs(hid_t number, hid_t file, const Hdf5Column& column, hsize_t first, hsize_t count) {
  const Hdf5Handle dataset(H5Dopen2(file, column.path.c_str(), H5P_DEFAULT), H5Dclose);
  requireOwnData(dataset.get(), column.path);
  const Hdf5Handle type(memoryType(column, number), H5Tclose);
  const Hdf5Handle space(dataset ? H5Dget_space(dataset.get()) : -1, H5Sclose);
  // For a vector, only the first number of each pair applies.
  const bool samples_first = column.rank == 1 || !column.wide;
  const std::array<hsize_t, 2> from = {samples_first ? first : column.part, samples_first ? column.part : first};
  const std::array<hsize_t, 2> size = {samples_first ? count : 1, samples_first ? 1 : count};
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  std::vector<Number> values(count);
  const bool selected =
      space && H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, from.data(), nullptr, size.data(), nullptr) >= 0;
  element::refuseIf<std::runtime_error>(
      !dataset || !selected ||
          H5Dread(dataset.get(), type.get(), memory.get(), space.get(), H5P_DEFAULT, values.data()) < 0,
      "{}: cannot be read; accepted: numbers, compressed with a filter that is installed with libhdf5", column.name);
  return values;
}

// Reads numbers as double. Throws if a double would round an 8-byte integer.
std::vector<double> readNumbers(hid_t file, const Hdf5Column& column, hsize_t first, hsize_t count) {
  if (!column.is_long) {
    return readAs<double>(H5T_NATIVE_DOUBLE, file, column, first, count);
  }
  const auto exact = readAs<long double>(H5T_NATIVE_LDOUBLE, file, column, first, count);
  std::vector<double> values(exact.begin(), exact.end());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    element::refuseIf<std::runtime_error>(
        static_cast<long double>(values[i]) != exact[i],
        "{}: element {}: {:.0f} is a whole number beyond 2^53, which a double rounds; accepted: floating point",
        column.name, first + i + 1, exact[i]);
  }
  return values;
}

class Hdf5File {
 public:
  explicit Hdf5File(const std::string& path) : file_(openHdf5(path), H5Fclose) {
    std::string pandas;  // path of the first table written by pandas
    visitObjects(file_.get(), [&](const std::string& object, const Hdf5Handle* dataset) {
      if (dataset == nullptr) {
        const bool is_table = H5Aexists_by_name(file_.get(), object.c_str(), "pandas_type", H5P_DEFAULT) > 0;
        pandas = pandas.empty() && is_table ? object : pandas;
      } else if (*dataset) {
        addDataset(columns_, dataset->get(), object);
      }
      return columns_.size() < kMostColumns;
    });
    element::refuseIf<std::runtime_error>(
        !pandas.empty(),
        "a table of pandas, which is not read; accepted: CSV, written with python3 -c \"import pandas; "
        "pandas.read_hdf('{}', '{}').reset_index().to_csv('LOG.csv', index=False)\"",
        path, pandas);
    element::refuseIf<std::runtime_error>(columns_.empty(),
                                          "no columns: {}; accepted: vectors or matrices of numbers, up to {} columns",
                                          describeDatasets(file_.get()), kMostColumns);
    nameColumns(columns_);
  }

  /// Returns the table of columns. A column of more than `most` numbers is refused. This object must outlive the table.
  ColumnTable table(std::size_t most) const {
    ColumnTable table{{}, {}, columns(most)};
    for (const Hdf5Column& column : columns_) {
      ColumnName name = parseColumnName(column.name, column.unit);
      name.bare = leafOf(name.bare);
      table.names.push_back(name);
      table.groups.push_back(folderOf(column));
    }
    return table;
  }

 private:
  ColumnFile columns(std::size_t most) const {
    return {[this, most](std::size_t place, const std::string& name) {
              element::refuseIf<std::runtime_error>(columns_[place].length > most,
                                                    "{0}: more than {1} numbers; accepted: at most {1}", name, most);
              return static_cast<std::size_t>(columns_[place].length);
            },
            [this](std::size_t place, const std::string&, std::size_t first, std::size_t count) {
              return readNumbers(file_.get(), columns_[place], first, count);
            },
            [this](std::size_t place, const std::string&, std::size_t first, std::size_t count) {
              return readAs<long double>(H5T_NATIVE_LDOUBLE, file_.get(), columns_[place], first, count);
            }};
  }

  Hdf5Handle file_;
  std::vector<Hdf5Column> columns_;
};

// Returns the result of `read` for a file. Other threads wait until `read` has returned.
template <class Read>
auto withHdf5File(const std::string& path, const Read& read) {
  const std::lock_guard<std::mutex> lock(hdf5Mutex());
  try {
    return read(Hdf5File(path));
  } catch (const LogError&) {
    throw;  // thrown by the consumer of the samples
  } catch (const std::runtime_error& error) {
    throw LogError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

std::vector<Log> readHdf5Logs(const std::string& path, const LogFormat& format) {
  return withHdf5File(
      path, [&](const Hdf5File& file) { return logsFromColumns(file.table(kMaximumLogRows), format, logName(path)); });
}

std::vector<std::string> readHdf5Blocks(const std::string& path, const LogFormat& format, const LogSource::Take& take) {
  return withHdf5File(path, [&](const Hdf5File& file) {
    return blocksFromColumns(file.table(kAllSamples), format, logName(path), kLogBlock, take);
  });
}

}  // namespace rubber_suspension::log
