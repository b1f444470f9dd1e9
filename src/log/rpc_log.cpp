// The format RPC III of MTS, in which rigs of MTS and Instron play and record. The header consists of records of 128
// bytes (32 for the key, 96 for the value) in blocks of 512 bytes. Data follow in groups, channel after channel.
#include "log/rpc_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>

#include "element/refuse.h"
#include "log/column_table.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

constexpr std::size_t kKey = 32;
constexpr std::size_t kRecord = 128;
constexpr std::size_t kBlock = 512;
constexpr std::size_t kMostChannels = 1000;
constexpr std::size_t kMostHeaderBlocks = 4096;

// Returns the text before the first NUL without blanks at its ends.
std::string fieldText(const char* bytes, std::size_t size) {
  return trimmed(toUtf8(std::string(bytes, std::find(bytes, bytes + size, '\0'))));
}

class RpcHeader {
 public:
  explicit RpcHeader(std::istream& file) {
    std::array<char, kRecord> record{};
    std::size_t blocks = 1;
    for (std::size_t i = 0; i < blocks * kBlock / kRecord; ++i) {
      element::refuseIf<std::runtime_error>(
          !file.read(record.data(), record.size()),
          "the header ends in record {}; accepted: a header of {} blocks of 512 bytes", i + 1, blocks);
      const std::string key = fieldText(record.data(), kKey);
      if (!key.empty()) {
        const bool is_new = values_.emplace(key, fieldText(record.data() + kKey, kRecord - kKey)).second;
        element::refuseIf<std::runtime_error>(!is_new, "record {}: {} is given twice; accepted: once", i + 1,
                                              oneLine(key));
      }
      if (i == 1) {
        blocks = number("NUM_HEADER_BLOCKS", 1, kMostHeaderBlocks);
      }
    }
    size_ = blocks * kBlock;
  }

  std::size_t size() const { return size_; }  ///< [byte]

  std::string text(const std::string& key, const std::string& otherwise = "") const {
    const auto value = values_.find(key);
    return value == values_.end() ? otherwise : value->second;
  }

  std::size_t number(const std::string& key, std::size_t least, std::size_t most) const {
    const std::string value = text(key);
    const auto parsed = parseNumber(value);
    const bool whole = parsed && *parsed >= static_cast<double>(least) && *parsed <= static_cast<double>(most) &&
                       *parsed == std::floor(*parsed);
    element::refuseIf<std::runtime_error>(!whole, "{} is {}; accepted: a whole number from {} to {}", key,
                                          value.empty() ? "missing" : quoted(value), least, most);
    return static_cast<std::size_t>(*parsed);
  }

  double real(const std::string& key, const std::string& accepted, const std::function<bool(double)>& holds) const {
    const std::string value = text(key);
    const auto parsed = parseNumber(value);
    element::refuseIf<std::runtime_error>(!parsed || !std::isfinite(*parsed) || !holds(*parsed),
                                          "{} is {}; accepted: {}", key, value.empty() ? "missing" : quoted(value),
                                          accepted);
    return *parsed;
  }

  std::string oneOf(const std::string& key, const std::string& otherwise, const std::vector<std::string>& all) const {
    std::string value = text(key, otherwise);
    element::refuseIf<std::runtime_error>(std::find(all.begin(), all.end(), value) == all.end(),
                                          "{} is {}; accepted: {}", key, value.empty() ? "missing" : log::quoted(value),
                                          join(all));
    return value;
  }

 private:
  std::map<std::string, std::string> values_;
  std::size_t size_ = 0;
};

std::string ofChannel(const char* key, std::size_t channel) { return fmt::format("{}.CHAN_{}", key, channel); }

class RpcFile {
 public:
  explicit RpcFile(const std::string& path) : file_(openFile(path)), header_(file_) {
    readLayout();
    for (std::size_t c = 1; c <= channels_; ++c) {
      scale_.push_back(is_float_ ? 1.0 : header_.real(ofChannel("SCALE", c), "a number other than 0", [](double scale) {
        return scale != 0.0;
      }));
      noteScale(c);
    }
    checkSize();
  }

  // Returns a column of time, which is computed from the time step, and a column for each channel.
  ColumnTable table() {
    ColumnTable table;
    table.names.push_back(parseColumnName("time", "s"));
    for (std::size_t c = 1; c <= channels_; ++c) {
      const std::string name = header_.text(ofChannel("DESC", c));
      table.names.push_back(
          parseColumnName(name.empty() ? fmt::format("CHAN_{}", c) : name, header_.text(ofChannel("UNITS", c))));
    }
    table.groups.resize(table.names.size());
    table.file.length = [this](std::size_t, const std::string&) { return samples_; };
    table.file.read = [this](std::size_t place, const std::string&, std::size_t first, std::size_t count) {
      count = std::min(count, samples_ - first);
      return place == 0 ? times(first, count) : numbers(place - 1, first, count);
    };
    return table;
  }

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  static std::ifstream openFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    element::refuseIf<std::runtime_error>(!file, "cannot be opened");
    return file;
  }

  void readLayout() {
    const std::string format = header_.oneOf("FORMAT", "", {"BINARY_IEEE_LITTLE_END", "BINARY_IEEE_BIG_END", "BINARY"});
    big_end_ = format == "BINARY_IEEE_BIG_END";
    header_.oneOf("FILE_TYPE", "TIME_HISTORY", {"TIME_HISTORY"});
    is_float_ = header_.oneOf("DATA_TYPE", "SHORT_INTEGER", {"SHORT_INTEGER", "FLOATING_POINT"}) == "FLOATING_POINT";
    if (is_float_ && format == "BINARY") {
      notes_.emplace_back("FORMAT is BINARY: the numbers are read as IEEE, little-endian");
    }
    header_.oneOf("HALF_FRAMES", "0", {"0"});
    channels_ = header_.number("CHANNELS", 1, kMostChannels);
    dt_ = header_.real("DELTA_T", "a time step of 1 ns or more [s]", [](double dt) { return dt >= 1e-9; });
    frame_ = header_.number("PTS_PER_FRAME", 1, kMaximumLogRows);
    samples_ = frame_ * header_.number("FRAMES", 1, kMaximumLogRows / frame_);
    group_ = header_.text("PTS_PER_GROUP").empty() ? frame_ : header_.number("PTS_PER_GROUP", frame_, kMaximumLogRows);
    element::refuseIf<std::runtime_error>(
        group_ % frame_ != 0, "PTS_PER_GROUP is {}; accepted: a multiple of PTS_PER_FRAME, {}", group_, frame_);
    element::refuseIf<std::runtime_error>(samples_ < 2, "one sample; accepted: two or more");
    last_group_ = samples_ % group_ == 0 ? group_ : samples_ % group_;
  }

  // Adds a note if SCALE is ignored, because numbers of single precision are already in the unit of the channel.
  void noteScale(std::size_t channel) {
    const std::string key = ofChannel("SCALE", channel);
    const auto scale = parseNumber(header_.text(key, "1"));
    if (is_float_ && !(scale && *scale == 1.0)) {
      notes_.push_back(
          fmt::format("{} of {} is ignored, because it applies to integers only", key, oneLine(header_.text(key))));
    }
  }

  std::size_t width() const { return is_float_ ? sizeof(float) : sizeof(std::int16_t); }

  // Checks the size of the file. The last group may be padded to the full size or contain its frames only.
  void checkSize() {
    file_.seekg(0, std::ios::end);
    const auto size = static_cast<std::size_t>(file_.tellg());
    const std::size_t groups = (samples_ + group_ - 1) / group_;
    const std::size_t whole = header_.size() + groups * group_ * channels_ * width();
    const std::size_t shortest = header_.size() + samples_ * channels_ * width();
    const auto isOf = [&](std::size_t length) {  // exact size, or padded to a whole block
      return size == length || size == (length + kBlock - 1) / kBlock * kBlock;
    };
    element::refuseIf<std::runtime_error>(
        !isOf(whole) && !isOf(shortest),
        "the file has {} bytes; accepted: {} or {}, as follows from header, FRAMES, CHANNELS and DATA_TYPE", size,
        whole, shortest);
    last_group_ = isOf(whole) ? group_ : last_group_;
  }

  std::vector<double> times(std::size_t first, std::size_t count) const {
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = static_cast<double>(first + i) * dt_;
    }
    return result;
  }

  std::vector<double> numbers(std::size_t channel, std::size_t first, std::size_t count) {
    std::vector<double> result;
    result.reserve(count);
    while (result.size() < count) {
      const std::size_t sample = first + result.size();
      const std::size_t group = sample / group_;
      const std::size_t place = sample % group_;
      const bool is_last = (group + 1) * group_ >= samples_;
      const std::size_t length = is_last ? last_group_ : group_;
      const std::size_t piece = std::min(count - result.size(), length - place);
      const std::size_t at = header_.size() + (group * group_ * channels_ + channel * length + place) * width();
      appendNumbers(at, piece, scale_[channel], result);
    }
    return result;
  }

  void appendNumbers(std::size_t at, std::size_t count, double scale, std::vector<double>& to) {
    std::vector<char> bytes(count * width());
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at));
    element::refuseIf<std::runtime_error>(!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size())),
                                          "byte {}: cannot be read", at);
    for (auto number = bytes.begin(); number != bytes.end(); number += static_cast<std::ptrdiff_t>(width())) {
      if (big_end_) {
        std::reverse(number, number + static_cast<std::ptrdiff_t>(width()));
      }
      if (is_float_) {
        float value = 0.0F;
        std::memcpy(&value, &*number, sizeof value);
        to.push_back(static_cast<double>(value));
      } else {
        std::int16_t value = 0;
        std::memcpy(&value, &*number, sizeof value);
        to.push_back(scale * static_cast<double>(value));
      }
    }
  }

  std::ifstream file_;
  RpcHeader header_;
  bool big_end_ = false;
  bool is_float_ = false;
  std::size_t channels_ = 0;
  double dt_ = 0.0;             // time step [s]
  std::size_t frame_ = 0;       // samples per channel in a frame
  std::size_t group_ = 0;       // samples per channel in a group
  std::size_t last_group_ = 0;  // samples per channel in the last group
  std::size_t samples_ = 0;     // samples per channel in the file
  std::vector<double> scale_;
  std::vector<std::string> notes_;
};

// Returns the result of `read` for a file. Adds the path to errors.
template <class Read>
auto withRpcFile(const std::string& path, Read read) {
  try {
    RpcFile file(path);
    return read(file);
  } catch (const std::runtime_error& error) {
    throw LogError(fmt::format("{}: {}", path, error.what()));
  }
}

void appendTo(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

std::string record(const std::string& key, const std::string& value) {
  std::string bytes = key;
  bytes.resize(kKey, '\0');
  bytes += value.substr(0, kRecord - kKey - 1);
  bytes.resize(kRecord, '\0');
  return bytes;
}

}  // namespace

std::vector<Log> readRpcLogs(const std::string& path, const LogFormat& format) {
  return withRpcFile(path, [&](RpcFile& file) {
    std::vector<Log> logs = logsFromColumns(file.table(), format, logName(path));
    for (Log& log : logs) {
      appendTo(log.notes, file.notes());
    }
    return logs;
  });
}

std::vector<std::string> readRpcBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take) {
  return withRpcFile(path, [&](RpcFile& file) {
    std::vector<std::string> notes = blocksFromColumns(file.table(), format, logName(path), kLogBlock, take);
    appendTo(notes, file.notes());
    return notes;
  });
}

std::string rpcFile(double dt, const std::vector<RpcChannel>& channels) {
  constexpr std::size_t kFrame = 1024;  // samples per frame; rigs accept powers of two from 256 on
  element::refuseIf(channels.empty() || channels[0].values.empty(), "RPC III: no samples to write");
  const std::size_t samples = channels[0].values.size();
  const std::size_t frames = (samples + kFrame - 1) / kFrame;
  std::vector<std::pair<std::string, std::string>> records = {{"FORMAT", "BINARY_IEEE_LITTLE_END"},
                                                              {"NUM_HEADER_BLOCKS", ""},
                                                              {"NUM_PARAMS", ""},
                                                              {"FILE_TYPE", "TIME_HISTORY"},
                                                              {"TIME_TYPE", "DRIVE"},
                                                              {"DATA_TYPE", "FLOATING_POINT"},
                                                              {"DELTA_T", fmt::format("{:.9g}", dt)},
                                                              {"CHANNELS", std::to_string(channels.size())},
                                                              {"PTS_PER_FRAME", std::to_string(kFrame)},
                                                              {"FRAMES", std::to_string(frames)},
                                                              {"PTS_PER_GROUP", std::to_string(kFrame)},
                                                              {"HALF_FRAMES", "0"},
                                                              {"REPEATS", "1"},
                                                              {"INT_FULL_SCALE", "32752"},
                                                              {"PARENT_1", ""}};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const RpcChannel& channel = channels[c];
    element::refuseIf(channel.values.size() != samples,
                      "RPC III: {} has {} samples; accepted: {}, as in the other channels", channel.name,
                      channel.values.size(), samples);
    const auto [least, most] = std::minmax_element(channel.values.begin(), channel.values.end());
    for (const auto& [key, value] : {std::pair("DESC", channel.name),
                                     {"UNITS", channel.unit},
                                     {"SCALE", std::string("1.0")},
                                     {"LOWER_LIMIT", fmt::format("{:.9g}", *least)},
                                     {"UPPER_LIMIT", fmt::format("{:.9g}", *most)}}) {
      records.emplace_back(ofChannel(key, c + 1), value);
    }
  }
  const std::size_t blocks = (records.size() * kRecord + kBlock - 1) / kBlock;
  records[1].second = std::to_string(blocks);
  records[2].second = std::to_string(records.size());
  std::string bytes;
  for (const auto& [key, value] : records) {
    bytes += record(key, value);
  }
  bytes.resize(blocks * kBlock, '\0');
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (const RpcChannel& channel : channels) {
      for (std::size_t i = frame * kFrame; i < (frame + 1) * kFrame; ++i) {
        const auto value = static_cast<float>(channel.values[std::min(i, samples - 1)]);
        std::array<char, sizeof value> raw{};
        std::memcpy(raw.data(), &value, sizeof value);
        bytes.append(raw.data(), raw.size());
      }
    }
  }
  return bytes;
}

}  // namespace rubber_suspension::log
