// Reads logs from ROS bags.
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
#include <limits>
#include <numeric>
#include <optional>
#include <set>

#include "bag/bag_check.h"
#include "bag/message_field.h"
#include "element/refuse.h"
#include "log/column_table.h"
#include "log/file_format.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/text.h"
#include "rubber_suspension/component/pose_stream.h"

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
    // The slash in front lets a topic without one, "name/displacement", match "/name/displacement".
    if (log::endsWith("/" + connection->topic, end)) {
      topics.insert(connection->topic);
    }
  }
  return topics;
}

// Returns the only topic that ends in `wanted`, of the component if one is named. Throws if there is not exactly one.
std::string topicOf(const std::string& wanted, const rosbag::Bag& bag, const std::string& path,
                    const std::string& component) {
  const std::string end = component.empty() ? wanted : "/" + component + wanted;
  const std::set<std::string> topics = topicsEndingIn(bag, end);
  if (topics.empty()) {
    const std::set<std::string> others = topicsEndingIn(bag, wanted);
    const std::string cure =
        wanted != kDisplacement
            ? ""
            : fmt::format(
                  "; accepted: --columns displacement=/TOPIC/FIELD force=/TOPIC/FIELD, where /TOPIC is one of {}",
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

// The times of a message [ns].
struct Times {
  std::int64_t stamp;
  std::int64_t receipt;
};

// Calls `take` with the times and the content of each message on a topic.
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
      throw log::LogError(fmt::format("{}: {} has type {}, whose name or definition differs; accepted: {}", path, topic,
                                      instance.getDataType(), ros::message_traits::datatype<Message>()));
    }
    take({static_cast<std::int64_t>(message->header.stamp.toNSec()),
          static_cast<std::int64_t>(instance.getTime().toNSec())},
         *message);
  }
}

template <class Message>
Series readTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic) {
  Series series;
  readMessages<Message>(bag, path, topic, [&](const Times& times, const Message& message) {
    series.stamp.push_back(times.stamp);
    series.receipt.push_back(times.receipt);
    series.value.push_back(valueOf(message));
  });
  return series;
}

void checkIncreasing(const Series& series, const std::string& path, const std::string& topic,
                     const std::string& cure = "") {
  for (std::size_t i = 1; i < series.stamp.size(); ++i) {
    if (series.stamp[i] <= series.stamp[i - 1]) {
      throw log::LogError(fmt::format("{}: message {} on {}: stamp {:.9f} s does not increase (before: {:.9f} s){}",
                                      path, i + 1, topic, 1e-9 * static_cast<double>(series.stamp[i]),
                                      1e-9 * static_cast<double>(series.stamp[i - 1]), cure));
    }
  }
}

// The values of one quantity, from a topic or one of its fields; empty if the bag does not contain the quantity.
struct Channel {
  log::Quantity quantity;
  Series series;
  std::string topic;
  std::string unit;  // empty: the unit of the format, or else SI
};

// Suggests options for messages whose stamps are unusable. Only options that accept these messages are suggested.
std::string cureOf(const Series& series, bool may_have_rate) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < series.receipt.size(); ++i) {
    steps.push_back(series.receipt[i] - series.receipt[i - 1]);
  }
  const auto [shortest, longest] = std::minmax_element(steps.begin(), steps.end());
  const double span = 1e-9 * static_cast<double>(series.receipt.back() - series.receipt.front());
  const double rate = span > 0.0 ? static_cast<double>(steps.size()) / span : 0.0;
  std::vector<std::string> cures;
  if (*shortest > 0 && series.stamp != series.receipt) {
    cures.push_back(fmt::format("--clock receipt ({:.4g} Hz, steps of {:.3g} to {:.3g} ms)", rate,
                                1e-6 * static_cast<double>(*shortest), 1e-6 * static_cast<double>(*longest)));
  }
  if (may_have_rate) {
    cures.push_back(rate > 0.0 ? fmt::format("--sampling-rate {:.4g}", rate) : "--sampling-rate and its value");
  }
  return cures.empty() ? "" : fmt::format("; accepted: stamps that increase, or {}", fmt::join(cures, ", or "));
}

void keepOnly(Series& series, const std::vector<std::size_t>& places) {
  Series kept;
  for (const std::size_t i : places) {
    kept.stamp.push_back(series.stamp[i]);
    kept.receipt.push_back(series.receipt[i]);
    kept.value.push_back(series.value[i]);
  }
  series = std::move(kept);
}

// Sorts the messages by their stamps. Messages with the stamp 0 are omitted, except the first one.
void orderByStamps(Channel& channel, const std::string& path, bool may_have_rate, std::vector<std::string>& notes) {
  constexpr std::int64_t kReplay = 1000000000;  // [ns]; a larger step back begins a new replay, as in the node
  Series& series = channel.series;
  const std::size_t all = series.stamp.size();
  if (all > 1 && std::all_of(series.stamp.begin(), series.stamp.end(), [](std::int64_t stamp) { return stamp == 0; })) {
    throw log::LogError(fmt::format("{}: {}: header.stamp is 0 in each of {} messages: the publisher does not set it{}",
                                    path, channel.topic, all, cureOf(series, may_have_rate)));
  }
  std::vector<std::size_t> stamped;
  for (std::size_t i = 0; i < all; ++i) {
    if (i == 0 || series.stamp[i] != 0) {
      stamped.push_back(i);
    }
  }
  if (stamped.size() < all) {
    keepOnly(series, stamped);
    notes.push_back(
        fmt::format("{}: {} of {} messages have the stamp 0: omitted", channel.topic, all - stamped.size(), all));
  }
  std::vector<std::size_t> order(series.stamp.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::size_t overtaken = 0;
  std::int64_t latest = series.stamp.empty() ? 0 : series.stamp.front();
  for (const std::int64_t stamp : series.stamp) {
    overtaken += stamp < latest ? 1 : 0;
    if (latest - stamp > kReplay) {
      checkIncreasing(series, path, channel.topic, cureOf(series, may_have_rate));
    }
    latest = std::max(latest, stamp);
  }
  if (overtaken > 0) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return series.stamp[a] < series.stamp[b]; });
    keepOnly(series, order);
    notes.push_back(fmt::format("{}: {} of {} messages follow messages with later stamps: sorted by their stamps",
                                channel.topic, overtaken, series.stamp.size()));
  }
  checkIncreasing(series, path, channel.topic, cureOf(series, may_have_rate));
}

// Replaces the stamps if the format requests that. Sorts the messages by their stamps unless a rate replaces them.
void setStamps(std::vector<Channel>& channels, const std::string& path, const log::LogFormat& format,
               std::vector<std::string>& notes) {
  const Channel& displacement = channels[0];
  const Channel& force = channels[1];
  const std::size_t forces = force.series.stamp.size();
  const bool paired = forces == 0 || forces == displacement.series.stamp.size();
  if (format.rate) {
    element::refuseIf<log::LogError>(!paired,
                                     "{}: --sampling-rate: {} messages on {}, {} on {}; accepted: equal numbers", path,
                                     forces, force.topic, displacement.series.stamp.size(), displacement.topic);
    notes.push_back(
        fmt::format("the stamps are replaced by --sampling-rate {:g}{}", *format.rate,
                    channels[2].series.stamp.empty() ? "" : "; the temperature, whose times are unknown, is omitted"));
    channels[2].series = {};
    return;
  }
  for (Channel& channel : channels) {
    if (format.by_receipt) {
      channel.series.stamp = channel.series.receipt;
    }
    if (!channel.series.stamp.empty()) {
      orderByStamps(channel, path, paired, notes);
    }
  }
  if (format.by_receipt) {
    notes.emplace_back("the times of receipt are used");
  }
}

// Returns the temperature at each of the stamps. As in the node, a temperature holds from its stamp to the stamp of the
// next one, and temperatures that are not finite are ignored.
Series heldAt(const std::vector<std::int64_t>& stamps, const Channel& measured, std::vector<std::string>& notes) {
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < measured.series.value.size(); ++i) {
    if (std::isfinite(measured.series.value[i])) {
      finite.push_back(i);
    }
  }
  Series held;
  std::size_t early = 0;
  std::size_t j = 0;
  for (const std::int64_t stamp : finite.empty() ? std::vector<std::int64_t>() : stamps) {
    while (j + 1 < finite.size() && measured.series.stamp[finite[j + 1]] <= stamp) {
      ++j;
    }
    early += measured.series.stamp[finite[j]] > stamp ? 1 : 0;
    held.value.push_back(measured.series.value[finite[j]]);
  }
  if (early > 0) {
    notes.push_back(
        fmt::format("{}: {} samples before the first temperature get the first temperature", measured.topic, early));
  }
  return held;
}

template <class Number, class Value>
std::vector<Number> part(const std::vector<Value>& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

// Reads the channels like the columns of a table, so that units, clocks and gaps are treated as in any other file. A
// channel with stamps is a group with its own time; other channels join the displacement's group.
log::Log logOf(const std::string& path, std::vector<Channel> channels, log::LogFormat format) {
  std::vector<std::string> notes;
  for (const double value : channels[0].series.value) {
    element::refuseIf<log::LogError>(!std::isfinite(value), "{}: {}: {} is not finite; accepted: a finite number", path,
                                     channels[0].topic, value);
  }
  setStamps(channels, path, format, notes);
  channels[2].series = heldAt(channels[0].series.stamp, channels[2], notes);
  log::ColumnTable table;
  table.place = "message";
  table.is_own =
      std::none_of(channels.begin(), channels.end(), [](const auto& channel) { return channel.unit.empty(); });
  std::vector<const Series*> series;
  for (const Channel& channel : channels) {
    format.of[static_cast<std::size_t>(channel.quantity)].column = channel.series.value.empty() ? "" : channel.topic;
    const bool has_stamps = !format.rate && !channel.series.stamp.empty();
    const std::string& group = has_stamps ? channel.topic : channels[0].topic;
    if (has_stamps) {
      table.names.push_back({channel.topic + ".stamp", "time", "ns"});
    }
    if (!channel.series.value.empty()) {
      table.names.push_back({channel.topic, channel.topic, channel.unit});
    }
    table.groups.resize(table.names.size(), group);
    series.resize(table.names.size(), &channel.series);
  }
  format.of[static_cast<std::size_t>(log::Quantity::time)].column = format.rate ? "" : channels[0].topic + ".stamp";
  format.bridge = std::numeric_limits<double>::infinity();  // gaps are visible in the stamps
  table.file = {[&](std::size_t place, const std::string&) { return series[place]->value.size(); },
                [&](std::size_t place, const std::string&, std::size_t first, std::size_t count) {
                  return part<double>(series[place]->value, first, count);
                },
                [&](std::size_t place, const std::string&, std::size_t first, std::size_t count) {
                  return part<long double>(series[place]->stamp, first, count);
                }};
  try {
    log::Log log = log::onlyLog(path, log::logsFromColumns(table, format, log::logName(path)));
    log.notes.insert(log.notes.end(), notes.begin(), notes.end());
    return log;
  } catch (const std::runtime_error& error) {
    throw log::LogError(fmt::format("{}: {}", path, error.what()));
  }
}

Channel temperatureOf(const rosbag::Bag& bag, const std::string& path, const std::string& base) {
  return {log::Quantity::temperature, readTopic<sensor_msgs::Temperature>(bag, path, base + kTemperature),
          base + kTemperature, "degC"};
}

log::Log readOpenBag(const rosbag::Bag& bag, const std::string& path, const std::string& component,
                     const log::LogFormat& format) {
  const std::string topic = topicOf(kDisplacement, bag, path, component);
  const std::string base = topic.substr(0, topic.size() - std::string(kDisplacement).size());
  const std::string force_topic = base + kMeasuredForce;
  return logOf(path,
               {{log::Quantity::displacement, readTopic<Displacement>(bag, path, topic), topic, "m"},
                {log::Quantity::force, readTopic<MeasuredForce>(bag, path, force_topic), force_topic, "N"},
                temperatureOf(bag, path, base)},
               format);
}

using SixSeries = std::array<Series, component::kDirections>;

void append(SixSeries& series, const Times& times, const std::array<double, component::kDirections>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    series[k].stamp.push_back(times.stamp);
    series[k].receipt.push_back(times.receipt);
    series[k].value.push_back(values[k]);
  }
}

// The coordinates of poses, and the quaternions as the bag contains them.
struct PoseSeries {
  SixSeries coordinate;
  std::vector<log::PoseLog::Quaternion> quaternion;
};

PoseSeries readPoseTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic,
                         component::RotationMeasure measure) {
  PoseSeries poses;
  readMessages<geometry_msgs::PoseStamped>(bag, path, topic, [&](const Times& times, const auto& message) {
    const auto& p = message.pose.position;
    const auto& q = message.pose.orientation;
    const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
    if (!(std::abs(rotation.norm() - 1.0) <= component::PoseStream::kQuaternionTolerance)) {
      throw log::LogError(fmt::format("{}: message {} on {}: a quaternion of length {:g}; accepted: 1 +- {:g}", path,
                                      poses.quaternion.size() + 1, topic, rotation.norm(),
                                      component::PoseStream::kQuaternionTolerance));
    }
    const Eigen::Vector3d turn = component::coordinatesOf(measure, rotation.normalized()).value;
    append(poses.coordinate, times, {p.x, p.y, p.z, turn.x(), turn.y(), turn.z()});
    poses.quaternion.push_back({q.w, q.x, q.y, q.z});
  });
  checkIncreasing(poses.coordinate[0], path, topic);
  return poses;
}

SixSeries readWrenchTopic(const rosbag::Bag& bag, const std::string& path, const std::string& topic) {
  SixSeries wrench;
  readMessages<geometry_msgs::WrenchStamped>(bag, path, topic, [&](const Times& times, const auto& message) {
    const auto& f = message.wrench.force;
    const auto& m = message.wrench.torque;
    append(wrench, times, {f.x, f.y, f.z, m.x, m.y, m.z});
  });
  checkIncreasing(wrench[0], path, topic);
  return wrench;
}

// Reads each direction like a log of its own. All directions have measured forces at the same samples.
log::PoseLog readOpenPoses(const rosbag::Bag& bag, const std::string& path, const std::string& component,
                           component::RotationMeasure measure) {
  const std::string topic = topicOf(kPose, bag, path, component);
  const std::string base = topic.substr(0, topic.size() - std::string(kPose).size());
  PoseSeries series = readPoseTopic(bag, path, topic, measure);
  const SixSeries wrench = readWrenchTopic(bag, path, base + kMeasuredWrench);
  log::PoseLog poses;
  for (std::size_t k = 0; k < component::kDirections; ++k) {
    const Series& coordinate = series.coordinate[k];
    log::Log log =
        logOf(path,
              {{log::Quantity::displacement, coordinate, topic, "m"},
               {log::Quantity::force, wrench[k], base + kMeasuredWrench, "N"},
               k == 0 ? temperatureOf(bag, path, base) : Channel{log::Quantity::temperature, {}, "", "degC"}},
              {});
    poses.coordinate[k] = std::move(log.displacement);
    poses.wrench[k] = std::move(log.force);
    if (k == 0) {
      poses.name = log.name;
      poses.stamp = std::move(log.stamp);
      poses.counts = std::move(log.counts);
      poses.temperature = std::move(log.temperature);
      poses.notes = std::move(log.notes);
    }
  }
  poses.quaternion = std::move(series.quaternion);
  return poses;
}

log::Log readNamedFields(const rosbag::Bag& bag, const std::string& path, const log::LogFormat& format) {
  const auto field = [&](log::Quantity quantity) { return format.of[static_cast<std::size_t>(quantity)].column; };
  if (field(log::Quantity::displacement).empty() || !field(log::Quantity::time).empty()) {
    throw log::LogError(path +
                        ": --columns lacks the displacement or names a time; accepted for a bag: "
                        "displacement=/TOPIC/FIELD, optionally with force and temperature; the messages give the time");
  }
  std::vector<Channel> channels;
  for (const auto quantity : {log::Quantity::displacement, log::Quantity::force, log::Quantity::temperature}) {
    const std::string name = field(quantity);
    channels.push_back({quantity, name.empty() ? Series() : readField(bag, path, name), name, ""});
  }
  return logOf(path, std::move(channels), format);
}

bool namesColumns(const log::LogFormat& format) {
  return std::any_of(format.of.begin(), format.of.end(), [](const auto& channel) { return !channel.column.empty(); });
}

// Returns the result of `read` for the bag. Adds the path to errors.
template <class Read>
auto ofBag(const std::string& path, Read read) {
  try {
    checkBagStructure(path);
    rosbag::Bag bag;
    bag.open(path, rosbag::bagmode::Read);
    return read(bag);
  } catch (const log::LogError&) {
    throw;
  } catch (const std::exception& error) {  // rosbag throws many types of exceptions for damaged files
    throw log::LogError(fmt::format("{}: no readable bag: {}", path, error.what()));
  }
}

}  // namespace

log::Log readBagLog(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return ofBag(path, [&](const rosbag::Bag& bag) {
    return namesColumns(format) ? readNamedFields(bag, path, format) : readOpenBag(bag, path, component, format);
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
