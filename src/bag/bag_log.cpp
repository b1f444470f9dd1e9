// Reading logs from ROS bags.
#include "bag/bag_log.h"

#include <fmt/format.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/MeasuredForce.h>
#include <sensor_msgs/Temperature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "bag/bag_check.h"
#include "bag/message_field.h"
#include "log/column_name.h"
#include "log/file_format.h"
#include "log/log_columns.h"
#include "log/text.h"
#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::bag {
namespace {

constexpr const char* kDisplacement = "/displacement";
constexpr const char* kMeasuredForce = "/measured_force";
constexpr const char* kTemperature = "/temperature";
constexpr const char* kPose = "/pose";
constexpr const char* kMeasuredWrench = "/measured_wrench";

std::set<std::string> topicsEndingIn(const rosbag::Bag& bag, const std::string& end) {
  std::set<std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    // A leading slash makes "name/displacement" end in "/name/displacement" too.
    if (log::endsWith("/" + connection->topic, end)) {
      topics.insert(connection->topic);
    }
  }
  return topics;
}

// The only topic of that end that fits. What precedes the end is common to all topics of the component.
std::string topicOf(const std::string& wanted, const rosbag::Bag& bag, const std::string& path,
                    const std::string& component) {
  const std::string end = component.empty() ? wanted : "/" + component + wanted;
  const std::set<std::string> topics = topicsEndingIn(bag, end);
  if (topics.empty()) {
    const std::set<std::string> others = topicsEndingIn(bag, wanted);
    const std::string cure = wanted != kDisplacement
                                 ? ""
                                 : fmt::format(
                                       "; accepted: --columns displacement=/TOPIC/FIELD force=/TOPIC/FIELD, of "
                                       "its topics {}",
                                       fmt::join(topicsEndingIn(bag, ""), ", "));
    throw log::LogError(fmt::format(
        "{}: no topic ends in {}; the bag has {}", path, end,
        others.empty() ? "no " + wanted.substr(1) + " at all" + cure : fmt::format("{}", fmt::join(others, ", "))));
  }
  if (topics.size() > 1) {
    throw log::LogError(
        fmt::format("{}: several topics end in {}: {}; name the component", path, end, fmt::join(topics, ", ")));
  }
  return *topics.begin();
}

double valueOf(const Displacement& message) { return message.displacement; }
double valueOf(const MeasuredForce& message) { return message.force; }
double valueOf(const sensor_msgs::Temperature& message) { return message.temperature; }

// Hands out the messages of a topic with their stamps [ns].
template <class Message, class Take>
void readMessages(const rosbag::Bag& bag, const std::string& path, const std::string& topic, Take take) {
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  if (view.size() > log::kMaximumLogRows) {
    throw log::LogError(
        fmt::format("{}: {} messages on {}; accepted: at most {}", path, view.size(), topic, log::kMaximumLogRows));
  }
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<Message>();
    if (!message) {
      throw log::LogError(fmt::format("{}: {} has type {} of another definition or name; accepted: {}", path, topic,
                                      instance.getDataType(), ros::message_traits::datatype<Message>()));
    }
    take(static_cast<std::int64_t>(message->header.stamp.toNSec()), *message);
  }
}

template <class Message>
Series readTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic) {
  Series series;
  readMessages<Message>(bag, path, topic, [&](std::int64_t stamp, const Message& message) {
    series.stamp.push_back(stamp);
    series.value.push_back(valueOf(message));
  });
  return series;
}

void checkIncreasing(const Series& series, const std::string& path, const std::string& topic) {
  for (std::size_t i = 1; i < series.stamp.size(); ++i) {
    if (series.stamp[i] <= series.stamp[i - 1]) {
      throw log::LogError(fmt::format("{}: message {} on {}: stamp {:.9f} s does not increase (before: {:.9f} s)", path,
                                      i + 1, topic, 1e-9 * static_cast<double>(series.stamp[i]),
                                      1e-9 * static_cast<double>(series.stamp[i - 1])));
    }
  }
}

using ForceAt = std::function<std::optional<double>(std::int64_t)>;

// The measured force that has the stamp; to be asked for stamps that increase.
ForceAt forceOfSameStamp(const Series& measured) {
  return [&measured, j = std::size_t{0}](std::int64_t stamp) mutable -> std::optional<double> {
    while (j < measured.stamp.size() && measured.stamp[j] < stamp) {
      ++j;
    }
    const bool found = j < measured.stamp.size() && measured.stamp[j] == stamp;
    return found ? std::optional<double>(measured.value[j]) : std::nullopt;
  };
}

std::int64_t medianInterval(const Series& series) {
  std::vector<std::int64_t> intervals;
  for (std::size_t i = 1; i < series.stamp.size(); ++i) {
    intervals.push_back(series.stamp[i] - series.stamp[i - 1]);
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

// The measured force between the two stamps around the one asked for, taken as linear; none across missing samples.
ForceAt forceInBetween(const Series& measured) {
  const std::int64_t longest = 3 * medianInterval(measured);
  return [&measured, longest, j = std::size_t{0}](std::int64_t stamp) mutable -> std::optional<double> {
    while (j + 2 < measured.stamp.size() && measured.stamp[j + 1] < stamp) {
      ++j;
    }
    const std::int64_t before = measured.stamp[j];
    const std::int64_t after = measured.stamp[j + 1];
    if (stamp < before || stamp > after || after - before > longest) {
      return std::nullopt;
    }
    const double share = static_cast<double>(stamp - before) / static_cast<double>(after - before);
    return (1.0 - share) * measured.value[j] + share * measured.value[j + 1];
  };
}

// A force of another clock or rate has no stamps, or only a few by chance, in common with the displacement.
bool hasOwnClock(const Series& displacement, const Series& measured) {
  std::size_t common = 0;
  std::size_t i = 0;
  for (const std::int64_t stamp : measured.stamp) {
    while (i < displacement.stamp.size() && displacement.stamp[i] < stamp) {
      ++i;
    }
    common += i < displacement.stamp.size() && displacement.stamp[i] == stamp ? 1 : 0;
  }
  return measured.stamp.size() > 1 && 2 * common < measured.stamp.size();
}

// First sample and length of the longest stretch of displacements that all have a force; forces of it in `force`.
std::size_t longestMatch(const Series& displacement, const ForceAt& force_at, std::vector<double>& force) {
  std::size_t best_start = 0;
  std::vector<double> current;
  for (std::size_t i = 0; i < displacement.stamp.size(); ++i) {
    if (const auto value = force_at(displacement.stamp[i])) {
      current.push_back(*value);
    } else {
      current.clear();
    }
    if (current.size() > force.size()) {
      force = current;
      best_start = i + 1 - current.size();
    }
  }
  return best_start;
}

template <class Value>
void keep(std::vector<Value>& values, std::size_t start, std::size_t count) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(start);
  values = std::vector<Value>(first, first + static_cast<std::ptrdiff_t>(count));
}

void addMeasuredForce(const Series& displacement, const Series& measured, const std::string& topic, log::Log& log) {
  const bool own_clock = hasOwnClock(displacement, measured);
  const ForceAt force_at = own_clock ? forceInBetween(measured) : forceOfSameStamp(measured);
  const std::size_t start = longestMatch(displacement, force_at, log.force);
  const std::size_t count = log.force.size();
  const char* what = own_clock ? "a force around their stamp" : "a force of the same stamp";
  if (count == 0) {
    log.notes.push_back(fmt::format("{}: {}: no displacement has {}; ignored", log.name, topic, what));
    return;
  }
  if (own_clock) {
    log.notes.push_back(fmt::format(
        "{}: {}: stamps of a clock or rate of its own; interpolated linearly to the displacement's", log.name, topic));
  }
  if (count < displacement.stamp.size()) {
    log.notes.push_back(fmt::format("{}: {}: samples {} to {} of {} have {}; the others are left out", log.name, topic,
                                    start + 1, start + count, displacement.stamp.size(), what));
    keep(log.stamp, start, count);
    keep(log.displacement, start, count);
  }
}

// Those that the node would have taken.
Series finiteOnes(const Series& series) {
  Series finite;
  for (std::size_t i = 0; i < series.stamp.size(); ++i) {
    if (std::isfinite(series.value[i])) {
      finite.stamp.push_back(series.stamp[i]);
      finite.value.push_back(series.value[i]);
    }
  }
  return finite;
}

// As in the node, each temperature holds from its stamp to that of the next.
void addTemperature(const Series& measured, const std::string& topic, log::Log& log) {
  const Series finite = finiteOnes(measured);
  if (finite.stamp.empty()) {
    return;
  }
  checkIncreasing(finite, log.name, topic);
  std::size_t j = 0;
  std::size_t early = 0;
  for (const std::int64_t stamp : log.stamp) {
    while (j + 1 < finite.stamp.size() && finite.stamp[j + 1] <= stamp) {
      ++j;
    }
    early += finite.stamp[j] > stamp ? 1 : 0;
    log.temperature.push_back(finite.value[j]);
  }
  if (early > 0) {
    log.notes.push_back(
        fmt::format("{}: {}: {} samples before the first temperature take that one", log.name, topic, early));
  }
}

// A series and its topic, for notes; an empty one is not there.
struct Channel {
  Series series;
  std::string topic;
};

log::Log logOf(const std::string& path, const Series& displacement, const Channel& force, const Channel& temperature) {
  log::Log log;
  log.name = log::logName(path);
  log.stamp = displacement.stamp;
  log.displacement = displacement.value;
  if (!force.series.stamp.empty()) {
    addMeasuredForce(displacement, force.series, force.topic, log);
  }
  addTemperature(temperature.series, temperature.topic, log);
  log::checkLog(log);
  return log;
}

Channel temperatureOf(const rosbag::Bag& bag, const std::string& path, const std::string& base) {
  return {readTopic<sensor_msgs::Temperature>(bag, path, base + kTemperature), base + kTemperature};
}

log::Log readOpenBag(const rosbag::Bag& bag, const std::string& path, const std::string& component) {
  const std::string topic = topicOf(kDisplacement, bag, path, component);
  const Series displacement = readTopic<Displacement>(bag, path, topic);
  checkIncreasing(displacement, path, topic);
  const std::string base = topic.substr(0, topic.size() - std::string(kDisplacement).size());
  const std::string force_topic = base + kMeasuredForce;
  const Series force = readTopic<MeasuredForce>(bag, path, force_topic);
  checkIncreasing(force, path, force_topic);
  return logOf(path, displacement, {force, force_topic}, temperatureOf(bag, path, base));
}

using SixSeries = std::array<Series, component::kDirections>;

void append(SixSeries& series, std::int64_t stamp, const std::array<double, component::kDirections>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    series[k].stamp.push_back(stamp);
    series[k].value.push_back(values[k]);
  }
}

// Coordinates of poses, and the quaternions as they are.
struct PoseSeries {
  SixSeries coordinate;
  std::vector<log::PoseLog::Quaternion> quaternion;
};

PoseSeries readPoseTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic,
                         component::RotationMeasure measure) {
  PoseSeries poses;
  readMessages<geometry_msgs::PoseStamped>(bag, path, topic, [&](std::int64_t stamp, const auto& message) {
    const auto& p = message.pose.position;
    const auto& q = message.pose.orientation;
    const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
    if (!(std::abs(rotation.norm() - 1.0) <= component::PoseStream::kQuaternionTolerance)) {
      throw log::LogError(fmt::format("{}: message {} on {}: a quaternion of length {:g}; accepted: 1 +- {:g}", path,
                                      poses.quaternion.size() + 1, topic, rotation.norm(),
                                      component::PoseStream::kQuaternionTolerance));
    }
    const Eigen::Vector3d turn = component::coordinatesOf(measure, rotation.normalized()).value;
    append(poses.coordinate, stamp, {p.x, p.y, p.z, turn.x(), turn.y(), turn.z()});
    poses.quaternion.push_back({q.w, q.x, q.y, q.z});
  });
  checkIncreasing(poses.coordinate[0], path, topic);
  return poses;
}

SixSeries readWrenchTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic) {
  SixSeries wrench;
  readMessages<geometry_msgs::WrenchStamped>(bag, path, topic, [&](std::int64_t stamp, const auto& message) {
    const auto& f = message.wrench.force;
    const auto& m = message.wrench.torque;
    append(wrench, stamp, {f.x, f.y, f.z, m.x, m.y, m.z});
  });
  checkIncreasing(wrench[0], path, topic);
  return wrench;
}

// Each direction is matched as a log of its own; the stamps decide, so that all keep the same samples.
log::PoseLog readOpenPoses(const rosbag::Bag& bag, const std::string& path, const std::string& component,
                           component::RotationMeasure measure) {
  const std::string topic = topicOf(kPose, bag, path, component);
  const std::string base = topic.substr(0, topic.size() - std::string(kPose).size());
  PoseSeries series = readPoseTopic(bag, path, topic, measure);
  const SixSeries wrench = readWrenchTopic(bag, path, base + kMeasuredWrench);
  log::PoseLog poses;
  for (std::size_t k = 0; k < component::kDirections; ++k) {
    const Series& coordinate = series.coordinate[k];
    log::Log log = logOf(path, coordinate, {wrench[k], base + kMeasuredWrench},
                         k == 0 ? temperatureOf(bag, path, base) : Channel());
    poses.coordinate[k] = std::move(log.displacement);
    poses.wrench[k] = std::move(log.force);
    if (k == 0) {
      const auto first = std::lower_bound(coordinate.stamp.begin(), coordinate.stamp.end(), log.stamp.front());
      keep(series.quaternion, static_cast<std::size_t>(first - coordinate.stamp.begin()), log.size());
      poses.name = log.name;
      poses.stamp = std::move(log.stamp);
      poses.temperature = std::move(log.temperature);
      poses.notes = std::move(log.notes);
    }
  }
  poses.quaternion = std::move(series.quaternion);
  return poses;
}

// The numbers that the user names, in SI units; nothing where none are named.
Series namedSeries(const rosbag::Bag& bag, const std::string& path, const log::LogFormat& format,
                   log::Quantity quantity) {
  const log::LogFormat::Channel& channel = format.of[static_cast<std::size_t>(quantity)];
  if (channel.column.empty()) {
    return {};
  }
  Series series = readField(bag, path, channel.column);
  const std::string si = log::siUnit(quantity);
  const log::UnitConversion conversion(channel.unit.empty() ? si : log::spelledUnit(channel.unit, si), si);
  for (double& value : series.value) {
    value = channel.factor * conversion(value);
  }
  checkIncreasing(series, path, channel.column);
  return series;
}

log::Log readNamedFields(const rosbag::Bag& bag, const std::string& path, const log::LogFormat& format) {
  const auto field = [&](log::Quantity quantity) { return format.of[static_cast<std::size_t>(quantity)].column; };
  const std::string force_field = field(log::Quantity::force);
  if (field(log::Quantity::displacement).empty() || !field(log::Quantity::time).empty()) {
    throw log::LogError(path +
                        ": --columns of a bag; accepted: displacement=/TOPIC/FIELD and, where they are there, "
                        "force and temperature; time is that of the messages");
  }
  const Series displacement = namedSeries(bag, path, format, log::Quantity::displacement);
  const Channel force{namedSeries(bag, path, format, log::Quantity::force), force_field};
  const Channel temperature{namedSeries(bag, path, format, log::Quantity::temperature), "temperature"};
  log::Log log = logOf(path, displacement, force, temperature);
  log.notes.insert(log.notes.begin(), "displacement from " + field(log::Quantity::displacement) +
                                          (force_field.empty() ? "" : ", force from " + force_field));
  return log;
}

// Topics of this package are in SI units; a field of another message is in those of whoever made it.
log::UnitsAre unitsOf(const log::LogFormat& format) {
  const auto is_assumed = [&](log::Quantity quantity) {
    const log::LogFormat::Channel& channel = format.of[static_cast<std::size_t>(quantity)];
    return !channel.column.empty() && channel.unit.empty();
  };
  return format.accept_units                                                           ? log::UnitsAre::accepted
         : is_assumed(log::Quantity::displacement) || is_assumed(log::Quantity::force) ? log::UnitsAre::assumed
                                                                                       : log::UnitsAre::named;
}

bool namesColumns(const log::LogFormat& format) {
  return std::any_of(format.of.begin(), format.of.end(), [](const auto& channel) { return !channel.column.empty(); });
}

// What `read` gives of the bag.
template <class Read>
auto ofBag(const std::string& path, Read read) {
  try {
    checkBagStructure(path);
    rosbag::Bag bag;
    bag.open(path, rosbag::bagmode::Read);
    return read(bag);
  } catch (const log::LogError&) {
    throw;
  } catch (const std::exception& error) {  // what rosbag throws on a damaged file is of many types
    throw log::LogError(fmt::format("{}: no readable bag: {}", path, error.what()));
  }
}

}  // namespace

log::Log readBagLog(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return ofBag(path, [&](const rosbag::Bag& bag) {
    log::Log log = namesColumns(format) ? readNamedFields(bag, path, format) : readOpenBag(bag, path, component);
    log.units = unitsOf(format);
    return log;
  });
}

log::PoseLog readBagPoses(const std::string& path, const std::string& component, component::RotationMeasure measure) {
  return ofBag(path, [&](const rosbag::Bag& bag) { return readOpenPoses(bag, path, component, measure); });
}

bool isBagPath(const std::string& path) {
  return log::endsWith(path, ".bag") || log::formatOfFile(path) == log::FileFormat::bag;
}

log::Log readAnyLog(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return isBagPath(path) ? readBagLog(path, component, format) : log::readLog(path, format);
}

std::vector<log::Log> readAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return isBagPath(path) ? std::vector<log::Log>{readBagLog(path, component, format)} : log::readLogs(path, format);
}

log::LogSources openAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return isBagPath(path) ? log::LogSources{log::sourceOf(readBagLog(path, component, format))}
                         : log::openLogs(path, format);
}

}  // namespace rubber_suspension::bag
