// The node's private parameters, checked strictly against one table.
#include "ros_interface/node_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/console.h>

#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>

#include "element/suggestion.h"
#include "io/cancellation.h"
#include "node/regular_file.h"
#include "ros_interface/command_line.h"
#include "ros_interface/node_interface.h"
#include "ros_interface/parameter_yaml.h"
#include "rubber_suspension/estimation/notes.h"

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

// Reads a value; false where it is not accepted.
using ReadSetting = std::function<bool(const XmlRpcValue&, NodeSettings&)>;

struct SettingInfo {
  std::string name;
  std::string accepted;
  std::string documentation;
  ReadSetting read;
};

// A value of exactly that type.
template <class Value, class Member>
ReadSetting ofType(XmlRpcValue::Type type, Member member) {
  return [=](const XmlRpcValue& value, NodeSettings& settings) {
    if (value.getType() != type) {
      return false;
    }
    std::invoke(member, settings) = static_cast<Value>(value);
    return true;
  };
}

template <class Member>
ReadSetting integerIn(Member member, int lower, int upper) {
  return [=, read = ofType<int>(XmlRpcValue::TypeInt, member)](const XmlRpcValue& value, NodeSettings& settings) {
    return read(value, settings) && std::invoke(member, settings) >= lower && std::invoke(member, settings) <= upper;
  };
}

// A whole number is one, too.
template <class Member>
ReadSetting positive(Member member, double upper) {
  return [=](const XmlRpcValue& value, NodeSettings& settings) {
    double& number = std::invoke(member, settings);
    const auto type = value.getType() == XmlRpcValue::TypeInt ? XmlRpcValue::TypeInt : XmlRpcValue::TypeDouble;
    const bool read = type == XmlRpcValue::TypeInt ? ofType<int>(type, member)(value, settings)
                                                   : ofType<double>(type, member)(value, settings);
    return read && number > 0.0 && number <= upper;
  };
}

ReadSetting flag(bool NodeSettings::*member) { return ofType<bool>(XmlRpcValue::TypeBoolean, member); }

ReadSetting path(std::string NodeSettings::*member) {
  return ofType<const std::string&>(XmlRpcValue::TypeString, member);
}

const std::vector<SettingInfo>& settingsTable() {
  static const std::vector<SettingInfo> table = {
      {"max_gap", "a number of seconds greater than 0, at most 1e6",
       "longest time between two samples; a longer time gap is reported and bridged exactly (default 0.5)",
       positive([](NodeSettings& settings) -> double& { return settings.max_gap; }, 1e6)},
      {"queue_size", "a whole number from 1 to 1000000",
       "samples that may wait per topic before the oldest is lost; four times as many forces, at least 40000, may wait "
       "for each subscriber (default 10000)",
       integerIn(&NodeSettings::queue_size, 1, 1000000)},
      {"threads", "a whole number from 1 to 64", "serving threads; components are assigned to them in turn (default 1)",
       integerIn(&NodeSettings::threads, 1, 64)},
      {"realtime_priority", "a whole number from 0 to 98",
       "SCHED_FIFO priority of the serving threads where permitted, 0 for none (default 0)",
       integerIn(&NodeSettings::realtime_priority, 0, 98)},
      {"lock_memory", "true or false", "keep the process in memory where permitted (default false)",
       flag(&NodeSettings::lock_memory)},
      {"state_file", "text, the path of a file", "where ~save_state and ~load_state keep the state (default none)",
       path(&NodeSettings::state_file)},
      {"load_state", "true or false", "continue from state_file at the start, if it exists (default false)",
       flag(&NodeSettings::load_state)},
      {"gap_window", "a number of seconds greater than 0, at most 1e5",
       "length of the sliding window of the live gap (default 10)",
       positive([](NodeSettings& settings) -> double& { return settings.gap.window; }, 1e5)},
      {"gap_warn", "a number greater than 0, at most 1e6",
       "live gap beyond noise, over the measured force's standard deviation, at which to warn (default 0.1)",
       positive([](NodeSettings& settings) -> double& { return settings.gap.warn; }, 1e6)},
      {"gap_error", "a number greater than 0, at most 1e6",
       "live gap beyond noise at which to report an error (default 0.3)",
       positive([](NodeSettings& settings) -> double& { return settings.gap.error; }, 1e6)},
      {"diagnose", "true or false",
       "diagnose the gap to the measured force while the bench runs, on COMPONENT/diagnosis (default false)",
       flag(&NodeSettings::diagnose)},
      {"diagnose_memory", "a whole number from 32768 to 10000000",
       "samples with a measured force that the live diagnosis keeps of each component (default 300000); about 70 bytes "
       "each",
       integerIn([](NodeSettings& settings) -> int& { return settings.live.memory; }, 32768, 10000000)},
      {"diagnose_nice", "a whole number from 0 to 19",
       "niceness of the thread that diagnoses; 19 takes what others leave (default 19)",
       integerIn([](NodeSettings& settings) -> int& { return settings.live.nice; }, 0, 19)},
      {"promote_file", "text, the path of a file",
       "component file with the models that COMPONENT/promote puts in place (default none: what the live diagnosis "
       "found)",
       path(&NodeSettings::promote_file)},
      {"promote_shadow", "a number of seconds greater than 0, at most 1e5",
       "time that a model is computed beside the configured one before it takes its place (default 5)",
       positive([](NodeSettings& settings) -> double& { return settings.promotion.shadow; }, 1e5)},
      {"promote_fade", "a number of seconds greater than 0, at most 1e5",
       "time of the cross-fade from one model to the other (default 1)",
       positive([](NodeSettings& settings) -> double& { return settings.promotion.fade; }, 1e5)},
  };
  return table;
}

// What others read from the node's private namespace.
bool isForeign(const std::string& name) {
  return name == "config_file" || name == "components" || name == "diagnostic_period" || name == "num_worker_threads";
}

std::vector<std::string> acceptedNames() {
  std::vector<std::string> names = {"config_file", "components"};
  for (const SettingInfo& setting : settingsTable()) {
    names.push_back(setting.name);
  }
  return names;
}

// The first level of every parameter below the node's private namespace.
std::vector<std::string> givenNames(const ros::NodeHandle& private_handle) {
  std::vector<std::string> all;
  private_handle.getParamNames(all);
  const std::string space = private_handle.getNamespace() + "/";
  std::vector<std::string> names;
  for (const std::string& name : all) {
    if (name.compare(0, space.size(), space) == 0) {
      names.push_back(name.substr(space.size(), name.find('/', space.size()) - space.size()));
    }
  }
  return names;
}

void refuseUnknown(const ros::NodeHandle& private_handle) {
  for (const std::string& name : givenNames(private_handle)) {
    const auto& table = settingsTable();
    const bool known = isForeign(name) || std::any_of(table.begin(), table.end(),
                                                      [&](const SettingInfo& setting) { return setting.name == name; });
    if (!known) {
      throw std::invalid_argument(fmt::format("unknown parameter {}/{}{}; accepted: {}", private_handle.getNamespace(),
                                              name, element::didYouMean(name, acceptedNames()),
                                              fmt::join(acceptedNames(), ", ")));
    }
  }
}

// Names that topics and services of the node have, or begin with.
std::set<std::string> reservedNames(const ros::NodeHandle& private_handle) {
  std::set<std::string> names = {"clock", "get_loggers", "parameter_updates", "rosout", "set_logger_level"};
  for (const InterfaceEntry& entry : nodeInterface()) {
    const std::string name = entry.name.substr(entry.name.find_first_not_of("~/"));
    if (name.find('/') == std::string::npos) {
      names.insert(name);
    }
  }
  const std::string& space = private_handle.getNamespace();
  names.insert(space.substr(space.rfind('/') + 1));
  return names;
}

void refuseReserved(const std::vector<io::ComponentDescription>& components, const std::string& source,
                    const ros::NodeHandle& private_handle) {
  const std::set<std::string> reserved = reservedNames(private_handle);
  for (const io::ComponentDescription& component : components) {
    if (reserved.count(component.name) > 0) {
      throw std::invalid_argument(
          fmt::format("{}: component {} is named as the node or as one of its topics or "
                      "services; accepted: any name but {}",
                      source, component.name, fmt::join(reserved, ", ")));
    }
  }
}

void warnOfSpecifications(const std::vector<io::ComponentDescription>& components, const std::string& source) {
  for (const io::ComponentDescription& component : components) {
    for (const std::string& warning : estimation::specificationWarnings(component.written())) {
      ROS_WARN("%s: component '%s': %s", source.c_str(), component.name.c_str(), warning.c_str());
    }
  }
}

std::string shown(const XmlRpcValue& value) {
  try {
    return toYamlText(value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

NodeSettings readNodeSettings(const ros::NodeHandle& private_handle) {
  refuseUnknown(private_handle);
  NodeSettings settings;
  for (const SettingInfo& setting : settingsTable()) {
    XmlRpcValue value;
    if (private_handle.getParam(setting.name, value) && !setting.read(value, settings)) {
      throw std::invalid_argument(fmt::format(
          "parameter {}: {}; accepted: {}", private_handle.resolveName(setting.name), shown(value), setting.accepted));
    }
  }
  if (settings.load_state && settings.state_file.empty()) {
    throw std::invalid_argument(fmt::format("parameter {} needs {}", private_handle.resolveName("load_state"),
                                            private_handle.resolveName("state_file")));
  }
  return settings;
}

std::vector<io::ComponentDescription> readComponents(const ros::NodeHandle& private_handle) {
  XmlRpcValue file;
  XmlRpcValue components;
  const bool has_file = private_handle.getParam("config_file", file);
  const bool has_components = private_handle.getParam("components", components);
  const std::string file_name = private_handle.resolveName("config_file");
  const std::string components_name = private_handle.resolveName("components");
  if (has_file == has_components) {
    throw std::invalid_argument(fmt::format("{} parameters {} and {}; accepted: exactly one of them",
                                            has_file ? "both" : "neither of the", file_name, components_name));
  }
  if (has_components) {
    auto parsed = io::parseComponentFile("components: " + toYamlText(components) + "\n", components_name);
    refuseReserved(parsed, components_name, private_handle);
    warnOfSpecifications(parsed, components_name);
    return parsed;
  }
  if (file.getType() != XmlRpcValue::TypeString) {
    throw std::invalid_argument(
        fmt::format("parameter {}: {}; accepted: text, the path of a file", file_name, shown(file)));
  }
  const auto& path = static_cast<const std::string&>(file);
  try {
    node::requireRegularFile(path);
    auto loaded = io::loadComponentFile(path);
    refuseReserved(loaded, path, private_handle);
    warnOfSpecifications(loaded, path);
    return loaded;
  } catch (const io::Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    throw std::invalid_argument(
        fmt::format("{} (the path is that of {})", error.what(), originOfParameter("config_file")));
  }
}

std::string describeNodeSettings() {
  std::string text;
  text += fmt::format("  ~{:18} {}\n", "config_file", "path of the component file");
  text += fmt::format("  ~{:18} {}\n", "components", "or what would stand in it under that key");
  for (const SettingInfo& setting : settingsTable()) {
    text += fmt::format("  ~{:18} {}; {}\n", setting.name, setting.documentation, setting.accepted);
  }
  return text;
}

}  // namespace rubber_suspension::ros_interface
