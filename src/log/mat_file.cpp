// Checks MATLAB files of level 4 or 5, and writes matrices by matio. Source: MathWorks, MAT-File Format, R2023b.
#include "log/mat_file.h"

#include <fmt/format.h>
#include <matio.h>
#include <zlib.h>

#include <algorithm>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "element/refuse.h"
#include "log/file_format.h"
#include "log/new_file.h"

namespace rubber_suspension::log {
namespace {

constexpr std::size_t kHeader = 128;                           // bytes of the header of level 5
constexpr std::size_t kDeepest = 64;                           // largest depth of structs within structs
constexpr std::size_t kLargestElement = 2048UL * 1024 * 1024;  // largest size of an element in bytes, uncompressed

enum DataType : std::uint32_t { kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kCompressed = 15 };
enum MatClass : std::uint32_t { kCell = 1, kStruct = 2, kObject = 3, kDouble = 6, kUint64 = 15, kOpaque = 17 };

// Bytes per number for each data type; 0 for types that are not numbers.
constexpr std::size_t kTypeSize[] = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};

struct Element {
  std::uint32_t type = 0;
  std::string_view data;
};

class ElementReader {
 public:
  ElementReader(std::string_view bytes, std::size_t place, bool swapped)
      : bytes_(bytes), place_(place), swapped_(swapped) {}

  bool atEnd() const { return at_ == bytes_.size(); }
  std::size_t place() const { return place_ + at_; }

  Element next() {
    const std::uint32_t first = number(at_);
    Element element;
    std::size_t begin = at_ + 8;
    std::size_t size = 0;
    if (first >> 16U != 0) {  // a small element, whose data are stored within its tag
      element.type = first & 0xFFFFU;
      size = first >> 16U;
      begin = at_ + 4;
      require(size <= 4, "a small element of more than 4 bytes");
    } else {
      element.type = first;
      size = number(at_ + 4);
    }
    require(begin <= bytes_.size() && size <= bytes_.size() - begin,
            "an element does not fit into the element that contains it");
    element.data = bytes_.substr(begin, size);
    const bool padded = element.type != kCompressed && begin == at_ + 8;
    at_ = begin == at_ + 4 ? at_ + 8 : std::min(begin + (padded ? (size + 7) / 8 * 8 : size), bytes_.size());
    require(at_ <= bytes_.size(), "an element is cut off");
    return element;
  }

  Element next(std::uint32_t type, const char* what) {
    const Element element = next();
    require(element.type == type, what);
    return element;
  }

  std::uint32_t numberIn(std::string_view data, std::size_t i) const {
    std::uint32_t value = 0;
    std::memcpy(&value, data.data() + 4 * i, 4);
    return swapped_ ? __builtin_bswap32(value) : value;
  }

  void require(bool condition, const char* what) const {
    element::refuseIf<std::runtime_error>(!condition, "damaged at byte {}: {}; accepted: a complete MATLAB file",
                                          place(), what);
  }

 private:
  std::uint32_t number(std::size_t at) const {
    require(at + 4 <= bytes_.size(), "the file ends early");
    return numberIn(bytes_.substr(at, 4), 0);
  }

  std::string_view bytes_;
  std::size_t place_;  // position of the first byte in the file
  bool swapped_;
  std::size_t at_ = 0;
};

class MatChecker {
 public:
  MatChecker(std::string_view file, bool large) : file_(file), large_(large) {}

  std::vector<std::string> check() {
    if (file_.size() < kHeader || file_.substr(0, 6) != "MATLAB") {
      checkLevel4();
      return {};
    }
    swapped_ = file_.substr(126, 2) == "MI";
    if (file_[swapped_ ? 124 : 125] != 1) {
      return {};  // level 7.3 is HDF5 and is checked as such
    }
    ElementReader reader(file_.substr(kHeader), kHeader, swapped_);
    while (!reader.atEnd()) {
      const std::size_t place = reader.place();
      const Element element = reader.next();
      if (element.type == kCompressed) {
        const std::string content = inflated(reader, element.data);
        ElementReader inner(content, place, swapped_);
        checkMatrix(inner.next(kMatrix, "the compressed data are no matrix").data, place, 0);
        inner.require(inner.atEnd(), "more than one matrix in a compressed element");
      } else {
        reader.require(element.type == kMatrix, "an element that is no matrix");
        checkMatrix(element.data, place, 0);
      }
    }
    return objects_;
  }

 private:
  // Decompresses an element. Its tag states the size; more data mean that the file is damaged.
  std::string inflated(const ElementReader& reader, std::string_view data) const {
    std::string content;
    z_stream stream{};
    reader.require(inflateInit(&stream) == Z_OK, "no memory to decompress");
    const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    int result = Z_OK;
    constexpr std::size_t kFirst = 65536;
    std::size_t most = kFirst;
    while (result == Z_OK && content.size() < most) {
      const std::size_t done = content.size();
      content.resize(std::min(std::max(2 * done, kFirst), most));
      stream.next_out = reinterpret_cast<Bytef*>(&content[done]);
      stream.avail_out = static_cast<uInt>(content.size() - done);
      result = inflate(&stream, Z_NO_FLUSH);
      content.resize(content.size() - stream.avail_out);
      if (done == 0 && result == Z_OK) {
        most = claimed(reader, content) + 1;  // one byte more than stated reveals surplus data
        refuseUnpacked(most, data.size(), large_);
      }
    }
    reader.require(result == Z_STREAM_END && stream.avail_in == 0, "compressed data that are cut off or changed");
    return content;
  }

  // Returns the size of a matrix [byte] according to its tag. Throws if the dimensions do not explain this size.
  std::size_t claimed(const ElementReader& reader, std::string_view begin) const {
    constexpr std::size_t kTag = 8;
    constexpr std::size_t kBeside = 1UL << 16U;  // bytes allowed for flags, dimensions and name
    reader.require(begin.size() >= kTag, "compressed data that are cut off or changed");
    ElementReader matrix(begin.substr(kTag), reader.place(), swapped_);
    const std::size_t size = kTag + reader.numberIn(begin, 1);
    reader.require(size <= kLargestElement, "dimensions larger than any file");
    if (begin.size() > kTag) {
      const Element flags = matrix.next(kUint32, "a matrix without flags");
      const std::uint32_t kind = flags.data.size() == kTag ? reader.numberIn(flags.data, 0) & 0xFFU : 0;
      if (kind >= kDouble && kind <= kUint64) {
        const std::size_t count = countOf(reader, matrix.next(kInt32, "a matrix without dimensions").data);
        constexpr std::size_t kLargestNumber = 16;  // bytes of a complex number
        reader.require(size / kLargestNumber <= count + kBeside, "more data than the matrix has");
      }
    }
    return size;
  }

  static std::size_t countOf(const ElementReader& reader, std::string_view dimensions) {
    std::size_t count = 1;
    for (std::size_t i = 0; i < dimensions.size() / 4; ++i) {
      const std::size_t size = reader.numberIn(dimensions, i);
      reader.require(size == 0 || count <= kLargestElement / size, "dimensions larger than any file");
      count *= size;
    }
    return count;
  }

  static void checkNumbers(ElementReader& reader, std::size_t count) {
    const Element numbers = reader.next();
    const std::size_t size = numbers.type < std::size(kTypeSize) ? kTypeSize[numbers.type] : 0;
    reader.require(size > 0 && numbers.data.size() == count * size,
                   "the count of numbers does not match the dimensions");
  }

  void checkMatrix(std::string_view data, std::size_t place, std::size_t depth) {
    if (data.empty()) {
      return;  // a field without a value
    }
    ElementReader reader(data, place, swapped_);
    reader.require(depth < kDeepest, "structs nested deeper than 64");
    const Element flags = reader.next(kUint32, "a matrix without flags");
    reader.require(flags.data.size() == 8, "flags of a wrong size");
    const std::uint32_t bits = reader.numberIn(flags.data, 0);
    const std::uint32_t kind = bits & 0xFFU;
    if (kind == kOpaque) {
      addObject(reader);
      return;
    }
    const std::size_t count = countOf(reader, reader.next(kInt32, "a matrix without dimensions").data);
    reader.next(kInt8, "a matrix without a name");
    if (kind >= kDouble && kind <= kUint64) {
      checkNumbers(reader, count);
      constexpr std::uint32_t kComplex = 0x0800;
      if ((bits & kComplex) != 0) {
        checkNumbers(reader, count);
      }
      reader.require(reader.atEnd(), "more data than the matrix has");
    } else if (kind == kCell || kind == kStruct || kind == kObject) {
      checkParts(reader, kind, count, depth);
    }
  }

  void checkParts(ElementReader& reader, std::uint32_t kind, std::size_t count, std::size_t depth) {
    std::size_t fields = 1;
    if (kind == kObject) {
      reader.next(kInt8, "an object without a class");
    }
    if (kind != kCell) {
      const Element length = reader.next(kInt32, "a struct without names");
      const std::size_t each = length.data.size() == 4 ? reader.numberIn(length.data, 0) : 0;
      const std::size_t names = reader.next(kInt8, "a struct without names").data.size();
      reader.require(each > 0 ? names % each == 0 : names == 0, "field names whose total length is wrong");
      fields = each > 0 ? names / each : 0;
    }
    for (std::size_t i = 0; i < count * fields; ++i) {
      const std::size_t place = reader.place();
      checkMatrix(reader.next(kMatrix, "a field that is no matrix").data, place, depth + 1);
    }
    reader.require(reader.atEnd(), "more data than the struct has");
  }

  void addObject(ElementReader& reader) {
    const std::string name(reader.next().data);
    reader.next();  // skips the type system of the object
    objects_.push_back(name + " (" + std::string(reader.next().data) + ")");
  }

  // Checks a file of level 4, which consists of matrices with a header of five numbers each.
  void checkLevel4() const {
    std::size_t at = 0;
    while (at < file_.size()) {
      const ElementReader whole(file_, 0, false);
      const auto failIf = [&](bool wrong, const char* reason) {
        element::refuseIf<std::runtime_error>(
            wrong, "damaged at byte {}: {}; accepted: a complete MATLAB file, level 4 to 7.3", at, reason);
      };
      failIf(file_.size() - at < 20, "the file ends early");
      const bool swapped = whole.numberIn(file_.substr(at, 4), 0) > 9999;
      const ElementReader header(file_, 0, swapped);
      const auto number = [&](std::size_t i) -> std::size_t { return header.numberIn(file_.substr(at, 20), i); };
      constexpr std::size_t kSizes[] = {8, 4, 4, 2, 2, 1};
      const std::size_t precision = number(0) / 10 % 10;
      failIf(number(0) > 9999 || precision > 5 || number(3) > 1 || number(4) == 0 || number(4) > 4096,
             "no header of a matrix");
      constexpr std::size_t kMost = kLargestElement / 16;
      failIf(number(1) > kMost || (number(1) > 0 && number(2) > kMost / number(1)), "dimensions larger than any file");
      const std::size_t size = 20 + number(4) + number(1) * number(2) * kSizes[precision] * (1 + number(3));
      failIf(size > file_.size() - at, "a matrix is cut off");
      at += size;
    }
  }

  std::string_view file_;
  bool large_;
  bool swapped_ = false;
  std::vector<std::string> objects_;
};

void writeMatrix(mat_t* file, const NamedMatrix& matrix, const std::string& path) {
  std::size_t sizes[] = {matrix.rows, matrix.columns};
  std::vector<double> values = matrix.values;
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(
      Mat_VarCreate(matrix.name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, values.data(), 0), Mat_VarFree);
  element::refuseIf<std::runtime_error>(!variable || Mat_VarWrite(file, variable.get(), MAT_COMPRESSION_NONE) != 0,
                                        "{}: {} cannot be written", path, matrix.name);
}

}  // namespace

std::vector<std::string> checkMatStructure(const std::string& path, bool large) {
  namespace ipc = boost::interprocess;
  try {
    const ipc::file_mapping file(path.c_str(), ipc::read_only);
    const ipc::mapped_region region(file, ipc::read_only);
    return MatChecker({static_cast<const char*>(region.get_address()), region.get_size()}, large).check();
  } catch (const ipc::interprocess_exception& error) {
    throw std::runtime_error(fmt::format("cannot be read: {}", error.what()));
  }
}

void writeMatFile(const std::string& path, const std::vector<NamedMatrix>& matrices) {
  NewFile file(path);
  {
    const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(
        Mat_CreateVer(file.writingPath().c_str(), "rubber_suspension", MAT_FT_MAT5), Mat_Close);
    element::refuseIf<std::runtime_error>(!mat, "{}: cannot be written", path);
    for (const NamedMatrix& matrix : matrices) {
      writeMatrix(mat.get(), matrix, path);
    }
  }
  file.commit();
}

}  // namespace rubber_suspension::log
