// Checks the structure of a bag before it is read.
#include "rubber_suspension/ros_interface/bag_check.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

#include "rubber_suspension/io/log.h"

namespace rubber_suspension {
namespace {

constexpr const char* kVersion = "#ROSBAG V2.0\n";
constexpr std::uint32_t kLongestHeader = 1024 * 1024;
constexpr std::uint32_t kLargestChunk = 256 * 1024 * 1024;  // uncompressed; rosbag writes less than 1 MiB by default
constexpr std::size_t kIndexEntry = 12;                     // time in two words, offset
constexpr std::size_t kChunkInfoEntry = 8;                  // connection, number of messages

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
Number numberAt(const char* bytes) {  // little endian, as every machine is that ROS runs on
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
      throw LogError(fmt::format("{}: {}", path_, std::strerror(errno)));
    }
    if (take(std::strlen(kVersion)) != kVersion) {
      fail("no bag of version 2.0");
    }
    while (position_ < size_) {
      checkRecord();
    }
    for (const std::uint32_t connection : used_connections_) {
      if (connections_.count(connection) == 0) {
        fail(fmt::format("connection {} is used and nowhere described", connection));
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw LogError(fmt::format("{}: byte {}: {}", path_, position_, reason));
  }

  std::string take(std::uint64_t count) {
    if (count > size_ - position_) {
      fail(fmt::format("{} bytes are to follow, {} do", count, size_ - position_));
    }
    std::string bytes(count, '\0');
    if (!file_.read(bytes.data(), static_cast<std::streamsize>(count))) {
      fail("cannot be read");
    }
    position_ += count;
    return bytes;
  }

  std::uint32_t takeNumber() { return numberAt<std::uint32_t>(take(4).data()); }

  // name=value, each after its length.
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
      fail(fmt::format("a record has no {} of {} bytes", name, sizeof(Number)));
    }
    return numberAt<Number>(found->second.data());
  }

  void checkRecord() {
    const std::uint64_t start = position_;
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
        connections_.insert(field<std::uint32_t>(fields, "conn"));
        break;
      case kChunkInfo:
        checkChunkInfo(fields, data);
        break;
      default:
        fail("a record of unknown kind");
    }
  }

  void checkBagHeader(const Fields& fields) const {
    const auto index = field<std::uint64_t>(fields, "index_pos");
    if (index == 0) {
      throw LogError(fmt::format("{}: the bag has no index, it was not closed; run rosbag reindex", path_));
    }
    if (index > size_) {
      fail("the index lies behind the end of the file");
    }
  }

  void checkChunk(const Fields& fields, const std::string& data, std::uint64_t start) {
    chunks_.insert(start);
    chunk_size_ = field<std::uint32_t>(fields, "size");
    if (chunk_size_ > kLargestChunk) {
      fail(fmt::format("a chunk of {} bytes; accepted: at most {}", chunk_size_, kLargestChunk));
    }
    messages_.clear();
    const auto compression = fields.find("compression");
    plain_chunk_ = compression != fields.end() && compression->second == "none";
    if (!plain_chunk_) {
      return;
    }
    if (chunk_size_ != data.size()) {
      fail(fmt::format("a chunk of {} bytes says that it has {}", data.size(), chunk_size_));
    }
    for (std::size_t at = 0; at < data.size();) {
      messages_.insert(static_cast<std::uint32_t>(at));
      at = skipPart(data, skipPart(data, at));
    }
  }

  // Behind a length and so many bytes.
  std::size_t skipPart(const std::string& data, std::size_t at) const {
    const std::size_t left = data.size() - at;
    const std::uint32_t length = left < 4 ? 0 : numberAt<std::uint32_t>(&data[at]);
    if (left < 4 || length > left - 4) {
      fail("a record does not fit into its chunk");
    }
    return at + 4 + length;
  }

  void checkIndex(const Fields& fields, const std::string& data) {
    used_connections_.insert(field<std::uint32_t>(fields, "conn"));
    if (data.size() != kIndexEntry * static_cast<std::uint64_t>(field<std::uint32_t>(fields, "count"))) {
      fail("an index is not as long as it says");
    }
    for (std::size_t at = 0; at < data.size(); at += kIndexEntry) {
      const auto offset = numberAt<std::uint32_t>(&data[at + 8]);
      if (plain_chunk_ ? messages_.count(offset) == 0 : offset >= chunk_size_) {
        fail(fmt::format("an index points at {}, where its chunk has no message", offset));
      }
    }
  }

  void checkChunkInfo(const Fields& fields, const std::string& data) {
    if (chunks_.count(field<std::uint64_t>(fields, "chunk_pos")) == 0) {
      fail("the index points at a chunk that is not there");
    }
    if (data.size() != kChunkInfoEntry * static_cast<std::uint64_t>(field<std::uint32_t>(fields, "count"))) {
      fail("the index of a chunk is not as long as it says");
    }
    for (std::size_t at = 0; at < data.size(); at += kChunkInfoEntry) {
      used_connections_.insert(numberAt<std::uint32_t>(&data[at]));
    }
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::set<std::uint64_t> chunks_;
  std::set<std::uint32_t> connections_;
  std::set<std::uint32_t> used_connections_;
  bool plain_chunk_ = false;
  std::uint32_t chunk_size_ = 0;      // of the chunk before, uncompressed
  std::set<std::uint32_t> messages_;  // where its records begin, if it is not compressed
};

}  // namespace

void checkBagStructure(const std::string& path) { BagChecker(path).check(); }

}  // namespace rubber_suspension
