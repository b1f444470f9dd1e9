// MATLAB and HDF5 files that are cut, changed, or lead elsewhere: refused, never read as zeros.
#include <gmock/gmock.h>
#include <hdf5.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "io/temporary_file.h"
#include "rubber_suspension/log/log.h"
#include "support/message_of.h"

namespace rubber_suspension {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusalOfBytes(const std::string& name, const std::string& bytes) {
  const TemporaryFile file(name, bytes);
  return messageOf<log::LogError>([&] { log::readLogs(file.path()); });
}

// Level 5 of MATLAB, written by its format.
class MatBytes {
 public:
  static std::string header() {
    std::string text(116, ' ');
    text.resize(128, '\0');  // no data of a subsystem
    text.replace(0, 19, "MATLAB 5.0 MAT-file");
    text.replace(124, 4, std::string("\x00\x01IM", 4));
    return text;
  }

  // Up to four bytes stand within the tag.
  static std::string element(std::uint32_t type, const std::string& data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    const bool small = size > 0 && size <= 4;
    std::string padded = data;
    padded.resize(small ? 4 : (data.size() + 7) / 8 * 8);
    return (small ? words({type | size << 16U}) : words({type, size})) + padded;
  }

  static std::string matrix(std::uint32_t kind, std::uint32_t rows, std::uint32_t columns, const std::string& name,
                            const std::string& content) {
    return element(14, element(6, words({kind, 0})) + element(5, words({rows, columns})) + element(1, name) + content);
  }

  static std::string numbers(const std::string& name, const std::vector<double>& values) {
    std::string bytes(8 * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return matrix(6, static_cast<std::uint32_t>(values.size()), 1, name, element(9, bytes));
  }

  static std::string text(const std::string& name, const std::string& value) {
    return matrix(4, 1, static_cast<std::uint32_t>(value.size()), name, element(16, value));
  }

  // A struct, or a row of them: fields of each one after the other.
  static std::string structure(const std::string& name, const std::vector<std::string>& fields, std::uint32_t count,
                               const std::string& values) {
    std::string names;
    for (std::string field : fields) {
      field.resize(32);
      names += field;
    }
    return matrix(2, 1, count, name, element(5, words({32})) + element(1, names) + values);
  }

  static std::string compressed(const std::string& matrix) {
    std::vector<Bytef> bytes(compressBound(matrix.size()));
    uLongf size = bytes.size();
    compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(matrix.data()), matrix.size(), Z_BEST_SPEED);
    return words({15, static_cast<std::uint32_t>(size)}) +
           std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  }

 private:
  static std::string words(const std::vector<std::uint32_t>& values) {
    std::string bytes(4 * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
  }
};

constexpr std::size_t kRows = 100;

std::vector<double> channel(double scale) {
  std::vector<double> values(kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    values[i] = scale * std::sin(0.1 * static_cast<double>(i));
  }
  return values;
}

std::vector<double> times() {
  std::vector<double> values(kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    values[i] = 0.01 * static_cast<double>(i);
  }
  return values;
}

std::string plainMat() {
  return MatBytes::header() + MatBytes::numbers("time_s", times()) +
         MatBytes::numbers("displacement_mm", channel(1.0)) + MatBytes::numbers("force_N", channel(500.0));
}

std::string compressedMat() {
  return MatBytes::header() + MatBytes::compressed(MatBytes::numbers("time_s", times())) +
         MatBytes::compressed(MatBytes::numbers("displacement_mm", channel(1.0))) +
         MatBytes::compressed(MatBytes::numbers("force_N", channel(500.0)));
}

// As a scope of Simulink leaves it: structs within a struct, named by their labels.
std::string scopeMat() {
  const std::vector<std::string> fields = {"values", "label"};
  const std::string signals =
      MatBytes::structure("", fields, 2,
                          MatBytes::numbers("", channel(1.0)) + MatBytes::text("", "Displacement [mm]") +
                              MatBytes::numbers("", channel(500.0)) + MatBytes::text("", "Force [N]"));
  return MatBytes::header() +
         MatBytes::structure("ScopeData", {"time", "signals"}, 1, MatBytes::numbers("", times()) + signals);
}

void expectChannels(const log::Log& log) {
  ASSERT_EQ(log.size(), kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_EQ(log.stamp[i], static_cast<std::int64_t>(i) * 10000000);
    EXPECT_DOUBLE_EQ(log.displacement[i], 1e-3 * channel(1.0)[i]);
    EXPECT_DOUBLE_EQ(log.force[i], channel(500.0)[i]);
  }
}

TEST(MatFile, IsReadWhereItIsWhole) {
  for (const std::string& bytes : {plainMat(), compressedMat(), scopeMat()}) {
    const TemporaryFile file("log.mat", bytes);
    expectChannels(log::readLog(file.path()));
  }
}

TEST(MatFile, OfStructsWithALogEachHoldsSegments) {
  std::string bytes = MatBytes::header();
  for (const char* name : {"run1", "run2"}) {
    bytes += MatBytes::structure(
        name, {"time_s", "displacement_mm", "force_N"}, 1,
        MatBytes::numbers("", times()) + MatBytes::numbers("", channel(1.0)) + MatBytes::numbers("", channel(500.0)));
  }
  EXPECT_THAT(refusalOfBytes("log.mat", bytes), HasSubstr("2 logs in one file: 'run1', 'run2'"));
  const TemporaryFile file("log.mat", bytes);
  expectChannels(log::readLog(file.path(), log::makeLogFormat({}, "", 0.0, "", "2", -1.0)));
}

std::string zipped(const std::string& text) {
  const TemporaryFile file("log.csv.gz", "");
  const gzFile zip = gzopen(file.path().c_str(), "wb1");
  gzwrite(zip, text.data(), static_cast<unsigned>(text.size()));
  gzclose(zip);
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Files of some kilobytes that would take gigabytes, or minutes.
constexpr std::size_t kBeyond = 65UL * 1024 * 1024;  // bytes; more than is unpacked unasked

TEST(PackedFile, OfFarMoreThanItsSizeIsRefusedUnlessTheUserWantsIt) {
  std::string segments = "time_s,displacement_m,force_N\n";
  while (segments.size() < kBeyond) {
    segments += "\n1,1,1\n";
  }
  const std::string header = "time_s,displacement_m,force_N\n0,0,0\n1,1,1\n";
  for (const std::string& text : {segments, header + std::string(kBeyond, '\n')}) {
    const TemporaryFile file("log.csv.gz", zipped(text));
    for (const bool large : {false, true}) {
      log::LogFormat format;
      format.large = large;
      try {
        EXPECT_EQ(log::readLog(file.path(), format).size(), 2U);
        EXPECT_TRUE(large);
      } catch (const log::LogError& error) {
        EXPECT_THAT(error.what(), HasSubstr(large || text == segments ? "more than 10000 segments" : "or --large"));
      }
    }
  }
  EXPECT_THAT(refusalOfBytes("log.csv", zipped(zipped("time_s"))), HasSubstr("to convert it: gunzip"));
}

TEST(PackedFile, OfMatlabIsRefusedByWhatItClaims) {
  constexpr std::size_t kNumbers = kBeyond / sizeof(double);
  const std::string large = MatBytes::compressed(MatBytes::numbers("a", std::vector<double>(kNumbers)));
  const std::string rest = MatBytes::compressed(MatBytes::numbers("time_s", times())) +
                           MatBytes::compressed(MatBytes::numbers("displacement_mm", channel(1.0))) +
                           MatBytes::compressed(MatBytes::numbers("force_N", channel(500.0)));
  const TemporaryFile file("log.mat", MatBytes::header() + large + rest);
  EXPECT_THAT(refusalOfBytes("log.mat", MatBytes::header() + large + rest), HasSubstr("or --large"));
  log::LogFormat format;
  format.large = true;
  expectChannels(log::readLog(file.path(), format));
  // Dimensions that need less than the data are.
  const std::string few = MatBytes::matrix(6, 1, 1, "a", MatBytes::element(9, std::string(kBeyond, '\0')));
  EXPECT_THAT(refusalOfBytes("log.mat", MatBytes::header() + MatBytes::compressed(few)),
              HasSubstr("more data than the matrix has"));
}

TEST(MatFile, IsRefusedWhereverItIsCut) {
  std::mt19937 random(3);
  for (const std::string& bytes : {plainMat(), compressedMat(), scopeMat()}) {
    // Between two variables a file that is cut is a whole one with fewer of them.
    for (int i = 0; i < 150; ++i) {
      const std::size_t size = std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random);
      EXPECT_NE(refusalOfBytes("log.mat", bytes.substr(0, size)), "") << size << " of " << bytes.size();
    }
  }
}

TEST(MatFile, IsRefusedWhereAByteOfWhatIsCompressedIsChanged) {
  const std::string bytes = compressedMat();
  for (std::size_t at = 136; at + 4 < bytes.size(); at += 7) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x20);
    EXPECT_NE(refusalOfBytes("log.mat", changed), "") << at;
  }
}

TEST(MatFile, NamesTheTableThatItCannotRead) {
  const std::string opaque = MatBytes::element(
      14, MatBytes::element(6, std::string("\x11\x00\x00\x00\x00\x00\x00\x00", 8)) + MatBytes::element(1, "run") +
              MatBytes::element(1, "MCOS") + MatBytes::element(1, "table") +
              MatBytes::matrix(13, 1, 1, "", MatBytes::element(6, std::string(4, '\0'))));
  EXPECT_THAT(refusalOfBytes("log.mat", MatBytes::header() + opaque),
              testing::AllOf(HasSubstr("run (table)"), HasSubstr("writetable(NAME, 'LOG.csv')")));
}

// Writes by libhdf5, which closes what it opens.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::string& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;
  ~Hdf5Writer() { H5Fclose(file_); }

  hid_t file() const { return file_; }

  void group(const std::string& name) const {
    H5Gclose(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  // Nothing is written where there are no values.
  void dataset(const std::string& name, const std::vector<double>& values, hid_t properties = H5P_DEFAULT) const {
    const hsize_t size = values.empty() ? kRows : values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t dataset =
        H5Dcreate2(file_, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (!values.empty()) {
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Dclose(dataset);
    H5Sclose(space);
  }

  void integers(const std::string& name, const std::vector<std::int64_t>& values) const {
    const hsize_t size = values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t dataset =
        H5Dcreate2(file_, name.c_str(), H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    H5Sclose(space);
  }

  void log(const std::string& prefix) const {
    dataset(prefix + "time_s", times());
    dataset(prefix + "displacement_mm", channel(1.0));
    dataset(prefix + "force_N", channel(500.0));
  }

 private:
  hid_t file_;
};

std::string refusalOfHdf5(const std::string& path) {
  return messageOf<log::LogError>([&] { log::readLog(path); });
}

TEST(Hdf5File, OfGroupsWithALogEachHoldsSegments) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    writer.group("a");
    writer.group("b");
    writer.log("a/");
    writer.log("b/");
  }
  EXPECT_THAT(refusalOfHdf5(file.path()), HasSubstr("2 logs in one file: 'a', 'b'"));
  expectChannels(log::readLog(file.path(), log::makeLogFormat({}, "", 0.0, "", "1", -1.0)));
  EXPECT_EQ(log::readLogs(file.path(), log::makeLogFormat({}, "", 0.0, "", "all", -1.0)).size(), 2U);
}

// As converters of MDF files write them: groups of a rate of their own.
// Each group goes by its own time.
TEST(Hdf5File, OfGroupsOfTwoRatesIsOneLog) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    std::vector<double> values(100);
    std::iota(values.begin(), values.end(), 0.0);
    writer.group("a");
    writer.dataset("a/time_s", values);
    writer.dataset("a/displacement_mm", values);
    for (double& value : values) {
      value *= 2.0;
    }
    values.resize(50);
    writer.group("b");
    writer.dataset("b/time_s", values);
    writer.dataset("b/force_N", values);
  }
  const log::Log log = log::readLog(file.path());
  ASSERT_EQ(log.size(), 100U);
  EXPECT_EQ(log.force[98], 98.0);
  EXPECT_EQ(log.counts[98], 1.0);
  EXPECT_EQ(log.counts[97], 0.0);
}

// A group without a time goes by that of the displacement.
TEST(Hdf5File, OfColumnsOfTwoLengthsIsRefused) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    writer.dataset("time_s", std::vector<double>(100, 1.0));
    writer.dataset("displacement_mm", std::vector<double>(100, 1.0));
    writer.dataset("force_N", std::vector<double>(50, 1.0));
  }
  EXPECT_THAT(refusalOfHdf5(file.path()),
              HasSubstr("force_N has 50 values, displacement_mm has 100; accepted: as many in each column, or a time"));
}

TEST(Hdf5File, OfACompoundDatasetHasItsMembersAsColumns) {
  struct Row {
    double time_s;
    float displacement_mm;
    double force_N;
  };
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    std::vector<Row> rows(kRows);
    for (std::size_t i = 0; i < kRows; ++i) {
      rows[i] = {times()[i], static_cast<float>(i), channel(500.0)[i]};
    }
    const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
    H5Tinsert(type, "time_s", HOFFSET(Row, time_s), H5T_NATIVE_DOUBLE);
    H5Tinsert(type, "displacement_mm", HOFFSET(Row, displacement_mm), H5T_NATIVE_FLOAT);
    H5Tinsert(type, "force_N", HOFFSET(Row, force_N), H5T_NATIVE_DOUBLE);
    const hsize_t size = kRows;
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t dataset = H5Dcreate2(writer.file(), "run", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data());
    H5Dclose(dataset);
    H5Sclose(space);
    H5Tclose(type);
  }
  const log::Log log = log::readLog(file.path());
  ASSERT_EQ(log.size(), kRows);
  EXPECT_DOUBLE_EQ(log.displacement[7], 7e-3);
  EXPECT_EQ(log.force[7], channel(500.0)[7]);
}

// Of a log whose force is a dataset of these properties, without data of its own.
std::string refusalWhereTheForceHas(const std::function<void(hid_t)>& properties) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    writer.dataset("time_s", times());
    writer.dataset("displacement_mm", channel(1.0));
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
    properties(list);
    writer.dataset("force_N", {}, list);
    H5Pclose(list);
  }
  return refusalOfHdf5(file.path());
}

TEST(Hdf5File, IsRefusedWhereItsDataLieInAnotherFile) {
  const TemporaryFile secret("secret.txt", std::string(8 * kRows, 's'));
  const auto elsewhere = [&](hid_t force) { H5Pset_external(force, secret.path().c_str(), 0, 8 * kRows); };
  EXPECT_THAT(refusalWhereTheForceHas(elsewhere), HasSubstr("'force_N': its data lie in other files"));
}

TEST(Hdf5File, IsRefusedWhereADatasetIsAViewOfOthers) {
  const TemporaryFile source("source.h5", "");
  { Hdf5Writer(source.path()).log(""); }
  const auto view = [&](hid_t force) {
    const hsize_t size = kRows;
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    H5Pset_virtual(force, space, source.path().c_str(), "force_N", space);
    H5Sclose(space);
  };
  EXPECT_THAT(refusalWhereTheForceHas(view), HasSubstr("'force_N': its data lie in other files"));
}

TEST(Hdf5File, IsRefusedWhereDataWereNeverWritten) {
  const auto chunked = [](hid_t force) {
    const hsize_t chunk = 30;
    H5Pset_chunk(force, 1, &chunk);
  };
  for (const auto& layout : {std::function<void(hid_t)>(chunked), std::function<void(hid_t)>([](hid_t /*force*/) {})}) {
    EXPECT_THAT(refusalWhereTheForceHas(layout), HasSubstr("'force_N': data that were never written"));
  }
}

TEST(Hdf5File, IsRefusedWhereGroupsNestDeep) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    std::string path;
    for (int i = 0; i < 200; ++i) {
      path += "/g";
      writer.group(path);
    }
  }
  EXPECT_THAT(refusalOfHdf5(file.path()), HasSubstr("nested deeper than 32"));
}

TEST(Hdf5File, RoundsNoWholeNumberWithoutAWord) {
  constexpr std::int64_t kBig = (std::int64_t{1} << 53) + 1;
  constexpr std::int64_t kNow = 1764259200000000001;  // [ns] since 1970
  for (const std::int64_t force : {kBig - 1, kBig, -kBig}) {
    const TemporaryFile file("log.h5", "");
    {
      const Hdf5Writer writer(file.path());
      writer.integers("time_ns", {kNow, kNow + 1000003, kNow + 2000007});
      writer.dataset("displacement_m", {0.0, 1.0, 2.0});
      writer.integers("force_N", {1, force, 3});
    }
    const std::string refusal = refusalOfHdf5(file.path());
    if (force == kBig - 1) {
      ASSERT_EQ(refusal, "");
      const log::Log log = log::readLog(file.path());
      EXPECT_EQ(log.stamp, (std::vector<std::int64_t>{kNow, kNow + 1000003, kNow + 2000007}));
      EXPECT_EQ(log.force[1], static_cast<double>(kBig - 1));
    } else {
      EXPECT_THAT(refusal, AllOf(HasSubstr("force_N: element 2: "), HasSubstr(std::to_string(force)),
                                 HasSubstr("beyond 2^53"), HasSubstr("accepted")));
    }
  }
}

TEST(Hdf5File, NamesWhatIsThereInPlaceOfColumns) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    EXPECT_EQ(H5Fflush(writer.file(), H5F_SCOPE_LOCAL), 0);
  }
  EXPECT_THAT(refusalOfHdf5(file.path()), HasSubstr("no columns: no datasets; accepted: "));
  {
    const Hdf5Writer writer(file.path());
    const hsize_t size[] = {3, 4, 5};
    const hid_t space = H5Screate_simple(3, size, nullptr);
    H5Dclose(H5Dcreate2(writer.file(), "cube", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
  }
  EXPECT_THAT(refusalOfHdf5(file.path()), HasSubstr("no columns: 'cube' of 3 x 4 x 5; accepted: "));
}

TEST(Hdf5File, NamesATableOfPandas) {
  const TemporaryFile file("log.h5", "");
  {
    const Hdf5Writer writer(file.path());
    writer.group("run");
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t group = H5Gopen2(writer.file(), "run", H5P_DEFAULT);
    const hid_t attribute = H5Acreate2(group, "pandas_type", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Aclose(attribute);
    H5Gclose(group);
    H5Sclose(space);
  }
  EXPECT_THAT(refusalOfHdf5(file.path()), HasSubstr("pandas.read_hdf('" + file.path() + "', 'run').reset_index()"));
}

}  // namespace
}  // namespace rubber_suspension
