// MATLAB and HDF5 files that are truncated, altered, or refer to other files are refused. They are never read as zeros.
#include <hdf5.h>
#include <zlib.h>

#include "log/read_text.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::string refusalOfMat(const std::string& bytes) { return refusalOf(bytes, {}, "log.mat"); }

// Writes MATLAB files of level 5 byte by byte.
class MatBytes {
 public:
  static std::string header() {
    std::string text(116, ' ');
    text.resize(128, '\0');  // a header without subsystem-specific data
    text.replace(0, 19, "MATLAB 5.0 MAT-file");
    text.replace(124, 4, std::string("\x00\x01IM", 4));
    return text;
  }

  // Stores data of at most four bytes within the tag, as the format prescribes.
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

  // Returns a struct or a row of `count` structs. `values` contains the fields of each struct in turn.
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

std::vector<double> valuesOf(double (*law)(double)) {
  std::vector<double> values(kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    values[i] = law(static_cast<double>(i));
  }
  return values;
}

const std::vector<double> kTimes = valuesOf([](double i) { return 0.01 * i; });
const std::vector<double> kMillimetres = valuesOf([](double i) { return std::sin(0.1 * i); });
const std::vector<double> kNewtons = valuesOf([](double i) { return 500.0 * std::sin(0.1 * i); });

// Returns the columns of a log, each encoded by `wrap`.
template <class Wrap>
std::string columns(const Wrap& wrap) {
  return wrap(MatBytes::numbers("time_s", kTimes)) + wrap(MatBytes::numbers("displacement_mm", kMillimetres)) +
         wrap(MatBytes::numbers("force_N", kNewtons));
}

std::string plainMat() {
  return MatBytes::header() + columns([](const std::string& matrix) { return matrix; });
}

std::string compressedMat() { return MatBytes::header() + columns(MatBytes::compressed); }

// Returns a scope as Simulink saves it: structs within a struct, identified by their labels.
std::string scopeMat() {
  const std::vector<std::string> fields = {"values", "label"};
  const std::string signals =
      MatBytes::structure("", fields, 2,
                          MatBytes::numbers("", kMillimetres) + MatBytes::text("", "Displacement [mm]") +
                              MatBytes::numbers("", kNewtons) + MatBytes::text("", "Force [N]"));
  return MatBytes::header() +
         MatBytes::structure("ScopeData", {"time", "signals"}, 1, MatBytes::numbers("", kTimes) + signals);
}

void expectChannels(const log::Log& log) {
  ASSERT_EQ(log.size(), kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_EQ(log.stamp[i], static_cast<std::int64_t>(i) * 10000000);
    EXPECT_DOUBLE_EQ(log.displacement[i], 1e-3 * kMillimetres[i]);
    EXPECT_DOUBLE_EQ(log.force[i], kNewtons[i]);
  }
}

TEST(MatFile, IsReadWhereItIsWhole) {
  for (const std::string& bytes : {plainMat(), compressedMat(), scopeMat()}) {
    expectChannels(readText(bytes, {}, "log.mat"));
  }
}

TEST(MatFile, OfStructsWithALogEachHoldsSegments) {
  std::string bytes = MatBytes::header();
  for (const char* name : {"run1", "run2"}) {
    bytes += MatBytes::structure(
        name, {"time_s", "displacement_mm", "force_N"}, 1,
        MatBytes::numbers("", kTimes) + MatBytes::numbers("", kMillimetres) + MatBytes::numbers("", kNewtons));
  }
  EXPECT_THAT(refusalOfMat(bytes), HasSubstr("the file contains 2 logs: 'run1', 'run2'"));
  expectChannels(readText(bytes, byOption("--segment", "2"), "log.mat"));
}

std::string zipped(const std::string& text) {
  const TemporaryFile file("log.csv.gz", "");
  const gzFile zip = gzopen(file.path().c_str(), "wb1");
  gzwrite(zip, text.data(), static_cast<unsigned>(text.size()));
  gzclose(zip);
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// These files of some kilobytes have contents that would take gigabytes of memory, or minutes to read.
constexpr std::size_t kBeyond = 65UL * 1024 * 1024;  // bytes; more than is decompressed without --large

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
        const bool segmented = large || text == segments;
        const std::string too_much = fmt::format("its {} bytes; accepted: a smaller factor, or --large",
                                                 std::filesystem::file_size(file.path()));
        EXPECT_THAT(error.what(), HasSubstr(segmented ? "more than 10000 segments" : too_much));
      }
    }
  }
  EXPECT_THAT(refusalOf(zipped(zipped("time_s"))), HasSubstr("to convert it: gunzip"));
}

TEST(PackedFile, OfMatlabIsRefusedByWhatItClaims) {
  constexpr std::size_t kNumbers = kBeyond / sizeof(double);
  const std::string bytes = MatBytes::header() +
                            MatBytes::compressed(MatBytes::numbers("a", std::vector<double>(kNumbers))) +
                            columns(MatBytes::compressed);
  EXPECT_THAT(refusalOfMat(bytes), HasSubstr("or --large"));
  log::LogFormat format;
  format.large = true;
  expectChannels(readText(bytes, format, "log.mat"));
  // The dimensions of the matrix are smaller than its data.
  const std::string few = MatBytes::matrix(6, 1, 1, "a", MatBytes::element(9, std::string(kBeyond, '\0')));
  EXPECT_THAT(refusalOfMat(MatBytes::header() + MatBytes::compressed(few)), HasSubstr("more data than the matrix has"));
}

TEST(MatFile, IsRefusedWhereverItIsCut) {
  std::mt19937 random(3);
  for (const std::string& bytes : {plainMat(), compressedMat(), scopeMat()}) {
    // Only a cut exactly between two variables would give a valid file, with fewer variables.
    for (int i = 0; i < 150; ++i) {
      const std::size_t size = std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random);
      EXPECT_NE(refusalOfMat(bytes.substr(0, size)), "") << size << " of " << bytes.size();
    }
  }
}

TEST(MatFile, IsRefusedWhereAByteOfWhatIsCompressedIsChanged) {
  const std::string bytes = compressedMat();
  for (std::size_t at = 136; at + 4 < bytes.size(); at += 7) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x20);
    EXPECT_NE(refusalOfMat(changed), "") << at;
  }
}

TEST(MatFile, NamesTheTableThatItCannotRead) {
  const std::string opaque = MatBytes::element(
      14, MatBytes::element(6, std::string("\x11\x00\x00\x00\x00\x00\x00\x00", 8)) + MatBytes::element(1, "run") +
              MatBytes::element(1, "MCOS") + MatBytes::element(1, "table") +
              MatBytes::matrix(13, 1, 1, "", MatBytes::element(6, std::string(4, '\0'))));
  EXPECT_THAT(refusalOfMat(MatBytes::header() + opaque),
              testing::AllOf(HasSubstr("run (table)"), HasSubstr("writetable(NAME, 'LOG.csv')")));
}

// Creates a file with libhdf5, and closes the file before it is read.
class Hdf5 {
 public:
  Hdf5() : file_(H5Fcreate(temporary_.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  Hdf5(const Hdf5&) = delete;
  Hdf5& operator=(const Hdf5&) = delete;
  ~Hdf5() { close(); }

  hid_t file() const { return file_; }
  std::string path() const { return temporary_.path(); }

  void close() {
    if (file_ >= 0) {
      H5Fclose(std::exchange(file_, -1));
    }
  }

  void group(const std::string& name) const {
    H5Gclose(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  // Creates a dataset. If `values` is null, no data are written.
  void write(const std::string& name, hid_t type, const std::vector<hsize_t>& size, const void* values,
             hid_t properties = H5P_DEFAULT) const {
    const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
    const hid_t dataset = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (values != nullptr) {
      H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    }
    H5Dclose(dataset);
    H5Sclose(space);
  }
  void dataset(const std::string& name, const std::vector<double>& values) const {
    write(name, H5T_NATIVE_DOUBLE, {values.size()}, values.data());
  }
  void integers(const std::string& name, const std::vector<std::int64_t>& values) const {
    write(name, H5T_NATIVE_INT64, {values.size()}, values.data());
  }

  void log(const std::string& prefix) const {
    dataset(prefix + "time_s", kTimes);
    dataset(prefix + "displacement_mm", kMillimetres);
    dataset(prefix + "force_N", kNewtons);
  }

  log::Log read(const log::LogFormat& format = {}) {
    close();
    return log::readLog(path(), format);
  }
  std::string refusal() {
    return messageOf<log::LogError>([&] { read(); });
  }

 private:
  TemporaryFile temporary_{"log.h5", ""};
  hid_t file_;
};

TEST(Hdf5File, OfGroupsWithALogEachHoldsSegments) {
  Hdf5 file;
  for (const std::string group : {"a", "b"}) {
    file.group(group);
    file.log(group + "/");
  }
  EXPECT_THAT(file.refusal(), HasSubstr("the file contains 2 logs: 'a', 'b'"));
  expectChannels(file.read(byOption("--segment", "1")));
  EXPECT_EQ(log::readLogs(file.path(), byOption("--segment", "all")).size(), 2U);
}

// Converters of MDF files write a group for each rate. Each group has a time of its own.
TEST(Hdf5File, OfGroupsOfTwoRatesIsOneLog) {
  Hdf5 file;
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 0.0);
  file.group("a");
  file.dataset("a/time_s", values);
  file.dataset("a/displacement_mm", values);
  for (double& value : values) {
    value *= 2.0;
  }
  values.resize(50);
  file.group("b");
  file.dataset("b/time_s", values);
  file.dataset("b/force_N", values);
  const log::Log log = file.read();
  ASSERT_EQ(log.size(), 100U);
  EXPECT_EQ(log.force[98], 98.0);
  EXPECT_EQ(log.counts[98], 1.0);
  EXPECT_EQ(log.counts[97], 0.0);
}

// A group without a time of its own uses the time of the displacement.
TEST(Hdf5File, OfColumnsOfTwoLengthsIsRefused) {
  Hdf5 file;
  file.dataset("time_s", std::vector<double>(100, 1.0));
  file.dataset("displacement_mm", std::vector<double>(100, 1.0));
  file.dataset("force_N", std::vector<double>(50, 1.0));
  EXPECT_THAT(file.refusal(),
              HasSubstr("force_N has 50 values, displacement_mm has 100; accepted: equal numbers, or a separate time"));
}

TEST(Hdf5File, OfACompoundDatasetHasItsMembersAsColumns) {
  struct Row {
    double time_s;
    float displacement_mm;
    double force_N;
  };
  std::vector<Row> rows(kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    rows[i] = {kTimes[i], static_cast<float>(i), kNewtons[i]};
  }
  Hdf5 file;
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
  H5Tinsert(type, "time_s", HOFFSET(Row, time_s), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "displacement_mm", HOFFSET(Row, displacement_mm), H5T_NATIVE_FLOAT);
  H5Tinsert(type, "force_N", HOFFSET(Row, force_N), H5T_NATIVE_DOUBLE);
  file.write("run", type, {kRows}, rows.data());
  H5Tclose(type);
  const log::Log log = file.read();
  ASSERT_EQ(log.size(), kRows);
  EXPECT_DOUBLE_EQ(log.displacement[7], 7e-3);
  EXPECT_EQ(log.force[7], kNewtons[7]);
}

// Returns the refusal of a log whose force is a dataset with these properties and without any data.
std::string refusalWhereTheForceHas(const std::function<void(hid_t)>& properties) {
  Hdf5 file;
  file.dataset("time_s", kTimes);
  file.dataset("displacement_mm", kMillimetres);
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  properties(list);
  file.write("force_N", H5T_NATIVE_DOUBLE, {kRows}, nullptr, list);
  H5Pclose(list);
  return file.refusal();
}

TEST(Hdf5File, IsRefusedWhereItsDataLieInAnotherFile) {
  const TemporaryFile secret("secret.txt", std::string(8 * kRows, 's'));
  const auto elsewhere = [&](hid_t force) { H5Pset_external(force, secret.path().c_str(), 0, 8 * kRows); };
  EXPECT_THAT(refusalWhereTheForceHas(elsewhere), HasSubstr("'force_N': its data lie in other files"));
}

TEST(Hdf5File, IsRefusedWhereADatasetIsAViewOfOthers) {
  Hdf5 source;
  source.log("");
  source.close();
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
    EXPECT_THAT(refusalWhereTheForceHas(layout), HasSubstr("'force_N': the data were never written"));
  }
}

TEST(Hdf5File, IsRefusedWhereGroupsNestDeep) {
  Hdf5 file;
  std::string path;
  for (int i = 0; i < 200; ++i) {
    path += "/g";
    file.group(path);
  }
  EXPECT_THAT(file.refusal(), HasSubstr("nested more than 32 levels deep"));
}

TEST(Hdf5File, RoundsNoWholeNumberWithoutAWord) {
  constexpr std::int64_t kBig = (std::int64_t{1} << 53) + 1;
  constexpr std::int64_t kNow = 1764259200000000001;  // [ns] since 1970
  const std::vector<std::int64_t> stamps = {kNow, kNow + 1000003, kNow + 2000007};
  for (const std::int64_t force : {kBig - 1, kBig, -kBig}) {
    Hdf5 file;
    file.integers("time_ns", stamps);
    file.dataset("displacement_m", {0.0, 1.0, 2.0});
    file.integers("force_N", {1, force, 3});
    if (force == kBig - 1) {
      const log::Log log = file.read();
      EXPECT_EQ(log.stamp, stamps);
      EXPECT_EQ(log.force[1], static_cast<double>(kBig - 1));
    } else {
      EXPECT_THAT(file.refusal(), AllOf(HasSubstr("force_N: element 2: "), HasSubstr(std::to_string(force)),
                                        HasSubstr("beyond 2^53"), HasSubstr("accepted")));
    }
  }
}

TEST(Hdf5File, NamesWhatIsThereInPlaceOfColumns) {
  EXPECT_THAT(Hdf5().refusal(), HasSubstr("no columns: no datasets; accepted: "));
  Hdf5 file;
  file.write("cube", H5T_NATIVE_DOUBLE, {3, 4, 5}, nullptr);
  EXPECT_THAT(file.refusal(), HasSubstr("no columns: 'cube' of 3 x 4 x 5; accepted: "));
}

TEST(Hdf5File, NamesATableOfPandas) {
  Hdf5 file;
  file.group("run");
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t group = H5Gopen2(file.file(), "run", H5P_DEFAULT);
  const hid_t attribute = H5Acreate2(group, "pandas_type", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Aclose(attribute);
  H5Gclose(group);
  H5Sclose(space);
  EXPECT_THAT(file.refusal(), HasSubstr("pandas.read_hdf('" + file.path() + "', 'run').reset_index()"));
}

}  // namespace
}  // namespace rubber_suspension
