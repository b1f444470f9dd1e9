// Reads one number from every message on a topic. Layout: wiki.ros.org/ROS/Technical%20Overview and wiki.ros.org/msg.
#include "bag/message_field.h"

#include <fmt/format.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>
#include <sstream>

#include "log/text.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {
namespace {

constexpr int kSingle = -1;
constexpr int kAnyNumber = -2;

struct MessageField {
  std::string type;
  std::string name;
  int count = kSingle;
};

using MessageType = std::vector<MessageField>;

std::size_t builtinSize(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"bool", 1},  {"int8", 1},   {"uint8", 1},   {"byte", 1},   {"char", 1},
      {"int16", 2}, {"uint16", 2}, {"int32", 4},   {"uint32", 4}, {"float32", 4},
      {"int64", 8}, {"uint64", 8}, {"float64", 8}, {"time", 8},   {"duration", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

// The types in the definition of a message that the bag contains. The type of the message itself has the key "".
class Definition {
 public:
  explicit Definition(const std::string& text) {
    std::istringstream lines(text);
    MessageType* type = &types_[""];
    for (std::string line; std::getline(lines, line);) {
      line = line.substr(0, line.find('#'));
      std::istringstream words(line);
      std::string first;
      std::string second;
      words >> first >> second;
      if (first == "MSG:") {
        type = &types_[second];
      } else if (!second.empty() && line.find('=') == std::string::npos) {
        type->push_back(fieldOf(first, second));
      }
    }
  }

  const MessageType& root() const { return types_.at(""); }
  std::size_t types() const { return types_.size(); }

  /// Returns the fields of a type; nullptr for a builtin type. `type` may be given without the name of its package.
  const MessageType* find(const std::string& type) const {
    for (const auto& [name, fields] : types_) {
      if (!name.empty() && (name == type || name.substr(name.find('/') + 1) == type)) {
        return &fields;
      }
    }
    return nullptr;
  }

 private:
  static MessageField fieldOf(std::string type, const std::string& name) {
    const std::size_t bracket = type.find('[');
    int count = kSingle;
    if (bracket != std::string::npos) {
      const int told = std::atoi(type.c_str() + bracket + 1);
      count = told > 0 ? told : kAnyNumber;
      type.resize(bracket);
    }
    return {type, name, count};
  }

  std::map<std::string, MessageType> types_;
};

// One step of the path to a number: a field, or an element of an array field.
struct PathStep {
  std::string name;
  std::string element;  // index from 0, or a name; empty if the field is no array
};

std::vector<PathStep> stepsOf(const std::string& text) {
  std::vector<PathStep> steps;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("./[", at), text.size());
    if (end > at) {
      steps.push_back({text.substr(at, end - at), ""});
    }
    at = end + 1;
    if (end < text.size() && text[end] == '[' && !steps.empty()) {
      const std::size_t close = std::min(text.find(']', end), text.size());
      steps.back().element = text.substr(end + 1, close - end - 1);
      at = close + 1;
    }
  }
  return steps;
}

// Reads the bytes of a message according to its definition.
class MessageWalk {
 public:
  MessageWalk(const Definition& definition, const std::vector<std::uint8_t>& bytes)
      : definition_(definition), bytes_(bytes) {}

  std::optional<double> number(const std::vector<PathStep>& steps) {
    at_ = 0;
    depth_ = 0;
    return within(definition_.root(), steps, 0);
  }

  std::int64_t headerStamp() {
    at_ = 4;  // position after the sequence number
    const auto seconds = take<std::uint32_t>();
    return std::int64_t{1000000000} * seconds + take<std::uint32_t>();
  }

 private:
  template <class Number>
  Number take() {
    Number value{};
    std::memcpy(&value, bytes_.data() + advance(sizeof value), sizeof value);
    return value;
  }

  std::size_t advance(std::size_t size) {
    if (size > bytes_.size() - at_) {
      throw std::runtime_error("a message is shorter than its definition");
    }
    at_ += size;
    return at_ - size;
  }

  std::optional<double> within(const MessageType& type, const std::vector<PathStep>& steps, std::size_t step) {
    for (const MessageField& field : type) {
      if (field.name != steps[step].name) {
        skip(field, field.name == "name" && field.type == "string" ? &names_ : nullptr);
        continue;
      }
      if (field.count != kSingle && !skipToElement(field, steps[step].element)) {
        return std::nullopt;
      }
      if (const MessageType* inner = definition_.find(field.type)) {
        return step + 1 < steps.size() ? within(*inner, steps, step + 1) : std::nullopt;
      }
      return step + 1 == steps.size() ? std::optional<double>(builtin(field.type)) : std::nullopt;
    }
    return std::nullopt;
  }

  bool skipToElement(const MessageField& field, const std::string& element) {
    const std::size_t count = field.count == kAnyNumber ? take<std::uint32_t>() : static_cast<std::size_t>(field.count);
    const auto named = std::find(names_.begin(), names_.end(), element);
    const bool digits =
        !element.empty() && element.size() < 7 && element.find_first_not_of("0123456789") == std::string::npos;
    const std::size_t place = digits                  ? std::stoul(element)
                              : named != names_.end() ? static_cast<std::size_t>(named - names_.begin())
                                                      : count;
    skipElements(field.type, std::min(place, count), nullptr);
    return place < count;
  }

  void skip(const MessageField& field, std::vector<std::string>* texts) {
    const std::size_t count = field.count == kSingle      ? 1
                              : field.count == kAnyNumber ? take<std::uint32_t>()
                                                          : static_cast<std::size_t>(field.count);
    skipElements(field.type, count, texts);
  }

  void skipElements(const std::string& type, std::size_t count, std::vector<std::string>* texts) {
    if (const std::size_t size = builtinSize(type); size > 0) {
      advance(count <= bytes_.size() ? size * count : bytes_.size() + 1);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t begin = at_;
      skipOne(type, texts);
      if (at_ == begin) {
        return;  // the other elements do not occupy any bytes either
      }
    }
  }

  // Skips a text or a message.
  void skipOne(const std::string& type, std::vector<std::string>* texts) {
    if (type == "string") {
      const auto length = take<std::uint32_t>();
      const std::size_t begin = advance(length);
      if (texts != nullptr) {
        texts->emplace_back(reinterpret_cast<const char*>(bytes_.data()) + begin, length);
      }
    } else if (const MessageType* inner = definition_.find(type)) {
      skipMessage(type, *inner);
    } else {
      throw std::runtime_error("a type that the bag does not define: " + log::quoted(type));
    }
  }

  void skipMessage(const std::string& type, const MessageType& fields) {
    if (without_bytes_.count(type) > 0) {
      return;
    }
    if (++depth_ > definition_.types()) {
      throw std::runtime_error("a type that contains itself: " + log::quoted(type));
    }
    const std::size_t begin = at_;
    for (const MessageField& field : fields) {
      skip(field, nullptr);
    }
    --depth_;
    if (at_ == begin) {
      without_bytes_.insert(type);
    }
  }

  double builtin(const std::string& type) {
    if (type == "float64") return take<double>();
    if (type == "float32") return static_cast<double>(take<float>());
    if (type == "int8" || type == "byte") return take<std::int8_t>();
    if (type == "uint8" || type == "char" || type == "bool") return take<std::uint8_t>();
    if (type == "int16") return take<std::int16_t>();
    if (type == "uint16") return take<std::uint16_t>();
    if (type == "int32") return take<std::int32_t>();
    if (type == "uint32") return take<std::uint32_t>();
    if (type == "int64") return static_cast<double>(take<std::int64_t>());
    if (type == "uint64") return static_cast<double>(take<std::uint64_t>());
    throw std::runtime_error("a field of type " + type + "; accepted: a number");
  }

  const Definition& definition_;
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::set<std::string> without_bytes_;  // message types that occupy no bytes
  std::vector<std::string> names_;       // entries of the field `name`, as in JointState
};

bool hasField(const MessageType& type, const std::string& name) {
  return std::any_of(type.begin(), type.end(), [&](const MessageField& field) { return field.name == name; });
}

// Inserts the first field into a path that omits it. An empty path becomes the field `data`.
std::vector<PathStep> completed(std::vector<PathStep> steps, const Definition& definition) {
  if (steps.empty()) {
    steps = {{"data", ""}};
  }
  if (hasField(definition.root(), steps[0].name)) {
    return steps;
  }
  std::vector<std::string> outer;
  for (const MessageField& field : definition.root()) {
    const MessageType* inner = definition.find(field.type);
    if (inner != nullptr && field.count == kSingle && field.name != "header" && hasField(*inner, steps[0].name)) {
      outer.push_back(field.name);
    }
  }
  if (outer.size() != 1) {
    std::vector<std::string> names;
    for (const MessageField& field : definition.root()) {
      names.push_back(field.name);
    }
    throw std::runtime_error(
        fmt::format("no field {}; accepted: one of {}", log::quoted(steps[0].name), log::join(names)));
  }
  steps.insert(steps.begin(), PathStep{outer[0], ""});
  return steps;
}

// Returns the longest topic with which the text of a field begins.
std::string topicOf(const rosbag::Bag& bag, const std::string& field) {
  std::set<std::string> topics;
  std::string best;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    const std::string& topic = connection->topic;
    topics.insert(topic);
    const bool fits = field.compare(0, topic.size(), topic) == 0 &&
                      (field.size() == topic.size() || field[topic.size()] == '/' || field[topic.size()] == '.');
    best = fits && topic.size() > best.size() ? topic : best;
  }
  if (best.empty()) {
    throw std::runtime_error(
        fmt::format("{}: not a topic of the bag; accepted: one of {} with a field, as in /ft/wrench.force.z",
                    log::quoted(field), fmt::join(topics, ", ")));
  }
  return best;
}

Series readMessages(const rosbag::Bag& bag, const std::string& field) {
  const std::string topic = topicOf(bag, field);
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  if (view.size() > log::kMaximumLogRows) {
    throw std::runtime_error(fmt::format("{} messages; accepted: at most {}", view.size(), log::kMaximumLogRows));
  }
  const Definition definition(view.getConnections().at(0)->msg_def);
  const std::vector<PathStep> steps = completed(stepsOf(field.substr(topic.size())), definition);
  const bool has_header = !definition.root().empty() && definition.root()[0].name == "header";
  Series series;
  std::vector<std::uint8_t> bytes;
  for (const rosbag::MessageInstance& instance : view) {
    bytes.resize(instance.size());
    ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    instance.write(stream);
    MessageWalk walk(definition, bytes);
    const auto value = walk.number(steps);
    if (!value) {
      throw std::runtime_error(
          fmt::format("message {}: the field has no number; accepted: a field that is a number, with [NUMBER] or "
                      "[NAME] for an element of an array",
                      series.value.size() + 1));
    }
    series.value.push_back(*value);
    series.receipt.push_back(static_cast<std::int64_t>(instance.getTime().toNSec()));
    series.stamp.push_back(has_header ? walk.headerStamp() : series.receipt.back());
  }
  return series;
}

}  // namespace

Series readField(const rosbag::Bag& bag, const std::string& path, const std::string& field) {
  try {
    return readMessages(bag, field);
  } catch (const std::runtime_error& error) {
    throw log::LogError(fmt::format("{}: {}: {}", path, field, error.what()));
  }
}

}  // namespace rubber_suspension::bag
