// Checks the structure of a bag before rosbag reads it.
#include "bag/bag_check.h"

#include <fmt/format.h>
#include <rosbag/chunked_file.h>
#include <rosbag/exceptions.h>
#include <rosbag/stream.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {
namespace {

constexpr const char* kVersion = "#ROSBAG V2.0\n";
constexpr std::uint32_t kLongestHeader = 1024 * 1024;
constexpr std::uint32_t kLargestChunk = 64 * 1024 * 1024;  // uncompressed; by default rosbag writes less than 1 MiB
constexpr std::size_t kIndexEntry = 12;                    // bytes: a time of two words, and an offset
constexpr std::size_t kChunkInfoEntry = 8;                 // bytes: a connection, and its number of messages

enum Operation : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndexData = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

using Fields = std::map<std::string, std::string>;

template <class Number>
Number numberAt(const char* bytes) {  // little-endian, as all processors that ROS supports
  Number number;
  std::memcpy(&number, bytes, sizeof(number));
  return number;
}

class BagChecker {
 public:
  explicit BagChecker(const std::string& path) : path_(path) {
    errno = 0;
    file_.open(path, std::ios::binary);
    file_.seekg(0, std::ios::end);
    size_ = file_ ? static_cast<std::uint64_t>(file_.tellg()) : 0;
    file_.seekg(0);
  }

  void check() {
    if (!file_) {
      throw log::LogError(fmt::format("{}: {}", path_, std::strerror(errno)));
    }
    if (take(std::strlen(kVersion)) != kVersion) {
      fail("no bag of version 2.0");
    }
    while (position_ < size_) {
      checkRecord();
    }
    if (records_.count(index_) == 0 && index_ != size_) {
      fail("the index does not begin where the header of the bag states");
    }
    for (const std::uint32_t connection : used_connections_) {
      if (connections_.count(connection) == 0) {
        fail(fmt::format("connection {} is used, but no record describes it", connection));
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw log::LogError(fmt::format("{}: byte {}: {}", path_, position_, reason));
  }

  std::string take(std::uint64_t count) {
    if (count > size_ - position_) {
      throw log::LogError(
          fmt::format("{}: the bag is cut off at byte {}: {} bytes should follow byte {}, but only {} do; rosbag "
                      "reindex recovers the complete part",
                      path_, size_, count, position_, size_ - position_));
    }
    std::string bytes(count, '\0');
    if (!file_.read(bytes.data(), static_cast<std::streamsize>(count))) {
      fail("cannot be read");
    }
    position_ += count;
    return bytes;
  }

  std::uint32_t takeNumber() { return numberAt<std::uint32_t>(take(4).data()); }

  // A header is a sequence of texts name=value, each preceded by its length.
  Fields fieldsOf(const std::string& header) const {
    Fields fields;
    for (std::size_t at = 0; at < header.size();) {
      const std::size_t left = header.size() - at;
      const std::uint32_t length = left < 4 ? 0 : numberAt<std::uint32_t>(&header[at]);
      if (length == 0 || length > left - 4) {
        fail("a record's header is damaged");
      }
      const std::string field = header.substr(at + 4, length);
      const std::size_t equals = field.find('=');
      if (equals == std::string::npos) {
        fail("a record's header is damaged");
      }
      fields[field.substr(0, equals)] = field.substr(equals + 1);
      at += 4 + length;
    }
    return fields;
  }

  template <class Number>
  Number field(const Fields& fields, const std::string& name) const {
    const auto found = fields.find(name);
    if (found == fields.end() || found->second.size() != sizeof(Number)) {
      fail(fmt::format("a record has no field {} of {} bytes", name, sizeof(Number)));
    }
    return numberAt<Number>(found->second.data());
  }

  void checkRecord() {
    const std::uint64_t start = position_;
    records_.insert(start);
    const std::uint32_t header_length = takeNumber();
    if (header_length > kLongestHeader) {
      fail(fmt::format("a header of {} bytes; accepted: at most {}", header_length, kLongestHeader));
    }
    const Fields fields = fieldsOf(take(header_length));
    const std::string data = take(takeNumber());
    switch (field<std::uint8_t>(fields, "op")) {
      case kBagHeader:
        checkBagHeader(fields);
        break;
      case kChunk:
        checkChunk(fields, data, start);
        break;
      case kIndexData:
        checkIndex(fields, data);
        break;
      case kConnection:
        fieldsOf(data);  // checks the header within the data as well
        connections_.insert(field<std::uint32_t>(fields, "conn"));
        break;
      case kChunkInfo:
        checkChunkInfo(fields, data);
        break;
      default:
        fail("a record of unknown kind");
    }
  }

  void checkBagHeader(const Fields& fields) {
    index_ = field<std::uint64_t>(fields, "index_pos");
    if (index_ == 0) {
      throw log::LogError(
          fmt::format("{}: the bag has no index, because it was not closed; run rosbag reindex", path_));
    }
    const auto encryptor = fields.find("encryptor");
    if (encryptor != fields.end() && !encryptor->second.empty()) {
      fail("an encrypted bag");  // rosbag would load a plugin that the file names
    }
  }

  void checkChunk(const Fields& fields, const std::string& data, std::uint64_t start) {
    chunks_.insert(start);
    chunk_size_ = field<std::uint32_t>(fields, "size");
    if (chunk_size_ > kLargestChunk) {
      fail(fmt::format("a chunk of {} bytes; accepted: at most {}", chunk_size_, kLargestChunk));
    }
    const std::string content = decompress(fields, data);
    messages_.clear();
    for (std::size_t at = 0; at < content.size();) {
      const auto record_start = static_cast<std::uint32_t>(at);
      const Fields record = fieldsOf(takePart(content, at));
      const std::string body = takePart(content, at);
      const auto operation = field<std::uint8_t>(record, "op");
      if (operation == kMessage) {
        messages_.insert(record_start);
      } else if (operation == kConnection) {
        fieldsOf(body);
      } else {
        fail("a record of unknown kind in a chunk");
      }
    }
  }

  // Returns the uncompressed content of a chunk, which must have chunk_size_ bytes.
  std::string decompress(const Fields& fields, const std::string& data) const {
    const auto compression = fields.find("compression");
    const std::string kind = compression == fields.end() ? "" : compression->second;
    if (kind == "none" && data.size() == chunk_size_) {
      return data;
    }
    if (kind == "bz2") {
      return decompressBy<rosbag::BZ2Stream>(data);
    }
    if (kind == "lz4") {
      return decompressBy<rosbag::LZ4Stream>(data);
    }
    fail(
        fmt::format("a chunk of {} bytes states a size of {}; accepted: the size of the chunk itself, or a chunk "
                    "compressed with bz2 or lz4",
                    data.size(), chunk_size_));
  }

  template <class Stream>
  std::string decompressBy(std::string data) const {
    std::string content(chunk_size_, '\0');
    rosbag::ChunkedFile no_file;
    try {
      Stream(&no_file).decompress(reinterpret_cast<std::uint8_t*>(content.data()), chunk_size_,
                                  reinterpret_cast<std::uint8_t*>(data.data()),
                                  static_cast<std::uint32_t>(data.size()));
    } catch (const rosbag::BagException& error) {
      fail(fmt::format("a chunk cannot be decompressed: {}", error.what()));
    }
    return content;
  }

  // Reads a length at `at`. Returns the bytes after it and advances `at` past them.
  std::string takePart(const std::string& data, std::size_t& at) const {
    const std::size_t left = data.size() - at;
    const std::uint32_t length = left < 4 ? 0 : numberAt<std::uint32_t>(&data[at]);
    if (left < 4 || length > left - 4) {
      fail("a record does not fit into its chunk");
    }
    at += 4 + length;
    return data.substr(at - length, length);
  }

  void checkIndex(const Fields& fields, const std::string& data) {
    used_connections_.insert(field<std::uint32_t>(fields, "conn"));
    if (data.size() != kIndexEntry * static_cast<std::uint64_t>(field<std::uint32_t>(fields, "count"))) {
      fail("the length of an index does not match its count of messages");
    }
    for (std::size_t at = 0; at < data.size(); at += kIndexEntry) {
      const auto offset = numberAt<std::uint32_t>(&data[at + 8]);
      if (messages_.count(offset) == 0) {
        fail(fmt::format("an index points at {}, where its chunk has no message", offset));
      }
    }
  }

  void checkChunkInfo(const Fields& fields, const std::string& data) {
    if (chunks_.count(field<std::uint64_t>(fields, "chunk_pos")) == 0) {
      fail("the index points at a chunk that does not exist");
    }
    if (data.size() != kChunkInfoEntry * static_cast<std::uint64_t>(field<std::uint32_t>(fields, "count"))) {
      fail("the length of the index of a chunk does not match its count of connections");
    }
    for (std::size_t at = 0; at < data.size(); at += kChunkInfoEntry) {
      used_connections_.insert(numberAt<std::uint32_t>(&data[at]));
    }
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t index_ = 0;          // position of the index according to the header of the bag
  std::set<std::uint64_t> records_;  // positions at which records begin
  std::set<std::uint64_t> chunks_;
  std::set<std::uint32_t> connections_;
  std::set<std::uint32_t> used_connections_;
  std::uint32_t chunk_size_ = 0;      // uncompressed size of the last chunk
  std::set<std::uint32_t> messages_;  // positions in the last chunk at which messages begin
};

}  // namespace

void checkBagStructure(const std::string& path) { BagChecker(path).check(); }

}  // namespace rubber_suspension::bag
