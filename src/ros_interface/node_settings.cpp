// Private parameters of the node, checked strictly against one table.
#include "ros_interface/node_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/console.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <variant>

#include "element/each.h"
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

// A private parameter and the variable that it sets.
struct Setting {
  std::string name;
  std::variant<bool*, int*, double*, std::string*> value;
  double lower;  // smallest value of an integer; a real number must be greater
  double upper;
  std::string documentation;
};

std::vector<Setting> settingsTable(NodeSettings& settings) {
  return {
      {"max_gap", &settings.max_gap, 0, 1e6,
       "longest time between two samples [s]; a longer time gap is reported and bridged exactly (default 0.5)"},
      {"queue_size", &settings.queue_size, 1, 1e6,
       "samples that can wait on each topic before the oldest is lost; four times as many forces, at least 40000, can "
       "wait for each subscriber (default 10000)"},
      {"threads", &settings.threads, 1, 64, "serving threads; components are assigned to them in turn (default 1)"},
      {"realtime_priority", &settings.realtime_priority, 0, 98,
       "SCHED_FIFO priority of the serving threads, if permitted; 0: none (default 0)"},
      {"lock_memory", &settings.lock_memory, 0, 0, "lock the process in memory, if permitted (default false)"},
      {"without_rig", &settings.without_rig, 0, 0,
       "omit elements that describe the test rig: entries with of_rig, and delay, gain, zero and drift of the "
       "measuring chain (default false)"},
      {"state_file", &settings.state_file, 0, 0,
       "file in which ~save_state and ~load_state store the state (default none)"},
      {"load_state", &settings.load_state, 0, 0, "continue from state_file at the start, if it exists (default false)"},
      {"gap_window", &settings.gap.window, 0, 1e5, "length of the sliding window of the live gap [s] (default 10)"},
      {"gap_warn", &settings.gap.warn, 0, 1e6,
       "live gap beyond noise, relative to the measured force's standard deviation, at which to warn (default 0.1)"},
      {"gap_error", &settings.gap.error, 0, 1e6, "live gap beyond noise at which to report an error (default 0.3)"},
      {"diagnose", &settings.diagnose, 0, 0,
       "diagnose the gap to the measured force while the bench runs, and publish COMPONENT/diagnosis (default false)"},
      {"diagnose_memory", &settings.live.memory, 32768, 1e7,
       "number of samples with a measured force that the live diagnosis stores for each component, about 70 bytes each "
       "(default 300000)"},
      {"diagnose_nice", &settings.live.nice, 0, 19,
       "niceness of the diagnosing thread; 19: it only uses time that no other process needs (default 19)"},
      {"promote_file", &settings.promote_file, 0, 0,
       "component file with the models that COMPONENT/promote activates (default none: the models of the live "
       "diagnosis)"},
      {"promote_shadow", &settings.promotion.shadow, 0, 1e5,
       "time for which a model is computed in parallel before it replaces the configured model [s] (default 5)"},
      {"promote_fade", &settings.promotion.fade, 0, 1e5,
       "time of the cross-fade from one model to the other [s] (default 1)"},
  };
}

std::string accepted(const Setting& setting) {
  if (std::holds_alternative<int*>(setting.value)) {
    return fmt::format("a whole number from {:.0f} to {:.0f}", setting.lower, setting.upper);
  }
  if (std::holds_alternative<double*>(setting.value)) {
    return fmt::format("a number greater than {:.0f} and at most {:.0f}", setting.lower, setting.upper);
  }
  return std::holds_alternative<bool*>(setting.value) ? "true or false" : "text, the path of a file";
}

// Copies the value and returns true if it has exactly this type.
template <class Value>
bool take(const XmlRpcValue& given, XmlRpcValue::Type type, Value& value) {
  const bool fits = given.getType() == type;
  if (fits) {
    value = static_cast<const Value&>(given);
  }
  return fits;
}

// Stores the value in the variable of the setting. Returns false if the value is not accepted.
bool read(const XmlRpcValue& given, const Setting& setting) {
  if (bool* const* flag = std::get_if<bool*>(&setting.value)) {
    return take(given, XmlRpcValue::TypeBoolean, **flag);
  }
  if (std::string* const* text = std::get_if<std::string*>(&setting.value)) {
    return take(given, XmlRpcValue::TypeString, **text);
  }
  int whole = 0;
  const bool is_whole = take(given, XmlRpcValue::TypeInt, whole);
  if (int* const* number = std::get_if<int*>(&setting.value)) {
    **number = whole;
    return is_whole && whole >= setting.lower && whole <= setting.upper;
  }
  double& number = *std::get<double*>(setting.value);
  number = whole;
  return (is_whole || take(given, XmlRpcValue::TypeDouble, number)) && number > setting.lower &&
         number <= setting.upper;
}

// Throws for a private parameter that is not in the table and that no library reads.
void refuseUnknown(const ros::NodeHandle& private_handle, const std::vector<Setting>& table) {
  std::vector<std::string> known = {"config_file", "components"};
  for (const Setting& setting : table) {
    known.push_back(setting.name);
  }
  std::vector<std::string> parameters;
  private_handle.getParamNames(parameters);
  const std::string space = private_handle.getNamespace() + "/";
  for (const std::string& parameter : parameters) {
    const bool is_ours = parameter.compare(0, space.size(), space) == 0;
    const std::string name =
        is_ours ? parameter.substr(space.size(), parameter.find('/', space.size()) - space.size()) : known.front();
    if (name != "diagnostic_period" && name != "num_worker_threads" &&
        std::find(known.begin(), known.end(), name) == known.end()) {
      throw std::invalid_argument(fmt::format("unknown parameter {}{}{}; accepted: {}", space, name,
                                              element::didYouMean(name, known), fmt::join(known, ", ")));
    }
  }
}

// Returns the names that the node, its topics and its services use.
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

// Throws if a component has a reserved name. Logs warnings about specifications.
void checkComponents(const std::vector<io::ComponentDescription>& components, const std::string& source,
                     const ros::NodeHandle& private_handle) {
  const std::set<std::string> reserved = reservedNames(private_handle);
  for (const io::ComponentDescription& component : components) {
    if (reserved.count(component.name) > 0) {
      throw std::invalid_argument(fmt::format(
          "{}: component {} has the name of the node or of one of its topics or services; accepted: any name except {}",
          source, component.name, fmt::join(reserved, ", ")));
    }
    const auto warn = [&](const io::ComponentDescription& of) {
      for (const std::string& warning : estimation::specificationWarnings(of.written())) {
        ROS_WARN("%s: component '%s': %s", source.c_str(), of.name.c_str(), warning.c_str());
      }
    };
    warn(component);
    for (std::size_t i = 0; component.six && i < component::kDirections; ++i) {
      if (const auto& direction = component.six->directions[i]) {
        warn(*direction);
      }
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

std::vector<io::ComponentDescription> readWhole(const ros::NodeHandle& private_handle) {
  XmlRpcValue file;
  XmlRpcValue components;
  const bool has_file = private_handle.getParam("config_file", file);
  const bool has_components = private_handle.getParam("components", components);
  const std::string file_name = private_handle.resolveName("config_file");
  const std::string components_name = private_handle.resolveName("components");
  if (has_file == has_components) {
    throw std::invalid_argument(fmt::format("{} parameters {} and {} are set; accepted: exactly one of them",
                                            has_file ? "both" : "neither of the", file_name, components_name));
  }
  if (has_components) {
    auto parsed = io::parseComponentFile("components: " + toYamlText(components) + "\n", components_name);
    checkComponents(parsed, components_name, private_handle);
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
    checkComponents(loaded, path, private_handle);
    return loaded;
  } catch (const io::Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    throw std::invalid_argument(fmt::format("{} (path given by {})", error.what(), originOfParameter("config_file")));
  }
}

}  // namespace

NodeSettings readNodeSettings(const ros::NodeHandle& private_handle) {
  NodeSettings settings;
  const std::vector<Setting> table = settingsTable(settings);
  refuseUnknown(private_handle, table);
  for (const Setting& setting : table) {
    XmlRpcValue value;
    if (private_handle.getParam(setting.name, value) && !read(value, setting)) {
      throw std::invalid_argument(fmt::format(
          "parameter {}: {}; accepted: {}", private_handle.resolveName(setting.name), shown(value), accepted(setting)));
    }
  }
  if (settings.load_state && settings.state_file.empty()) {
    throw std::invalid_argument(fmt::format("parameter {} needs {}", private_handle.resolveName("load_state"),
                                            private_handle.resolveName("state_file")));
  }
  return settings;
}

std::vector<io::ComponentDescription> readComponents(const ros::NodeHandle& private_handle,
                                                     const NodeSettings& settings) {
  std::vector<io::ComponentDescription> components = readWhole(private_handle);
  if (settings.without_rig) {
    components = element::each(components, [](const io::ComponentDescription& one) { return one.withoutRig(); });
  }
  return components;
}

std::string describeNodeSettings() {
  constexpr const char* kLine = "  ~{:18} {}\n";
  std::string text = fmt::format(kLine, "config_file", "path of the component file") +
                     fmt::format(kLine, "components", "content of a component file, instead of config_file");
  NodeSettings defaults;
  for (const Setting& setting : settingsTable(defaults)) {
    text += fmt::format(kLine, setting.name, setting.documentation + "; " + accepted(setting));
  }
  return text;
}

}  // namespace rubber_suspension::ros_interface
