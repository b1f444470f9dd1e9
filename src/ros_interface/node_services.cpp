// What a bench may ask of the node besides forces.
#include "ros_interface/node_services.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "io/cancellation.h"
#include "node/regular_file.h"
#include "node/state_file.h"
#include "ros_interface/termination.h"
#include "ros_interface/timed_call.h"

namespace rubber_suspension::ros_interface {
namespace {

// The entry of that name, as all the lists here are small and unsorted.
template <class Entries, class Name>
auto findNamed(const Entries& entries, Name name_of, const std::string& name) {
  return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return name_of(entry) == name; });
}

// For every channel the entry of its name; throws unless the names are the same on both sides.
template <class Entries, class Name>
std::vector<const typename Entries::value_type*> matchByName(const Entries& entries, Name name_of,
                                                             const std::vector<node::ComponentChannel*>& channels) {
  std::vector<const typename Entries::value_type*> matched;
  for (const node::ComponentChannel* channel : channels) {
    const auto found = findNamed(entries, name_of, channel->name());
    if (found == entries.end()) {
      throw std::invalid_argument(fmt::format("component {} is missing", channel->name()));
    }
    matched.push_back(&*found);
  }
  for (const auto& entry : entries) {
    const std::string& name = name_of(entry);
    const auto channel_name = [](const node::ComponentChannel* channel) { return channel->name(); };
    if (findNamed(channels, channel_name, name) == channels.end()) {
      throw std::invalid_argument(
          fmt::format("component {} is not one of this node, which would need a restart", name));
    }
  }
  return matched;
}

void requireStateFile(const NodeSettings& settings) {
  if (settings.state_file.empty()) {
    throw std::invalid_argument("the parameter ~state_file is not set");
  }
}

}  // namespace

void loadStates(const std::string& path, node::ChannelGroup& group) {
  const std::vector<node::SavedState> states = node::readStateFile(path);
  const auto name_of = [](const node::SavedState& state) -> const std::string& { return state.component; };
  group.load(matchByName(states, name_of, group.channels()));
}

void exchangeModels(const std::vector<io::ComponentDescription>& descriptions, double max_gap,
                    node::ChannelGroup& group) {
  const auto name_of = [](const io::ComponentDescription& description) -> const std::string& {
    return description.name;
  };
  std::vector<std::shared_ptr<node::ComponentChannel::Model>> models;
  for (const io::ComponentDescription* description : matchByName(descriptions, name_of, group.channels())) {
    models.push_back(node::ComponentChannel::makeModel(*description, max_gap));
  }
  group.exchange(models);
}

NodeServices::NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
                           node::ChannelGroup& group, FoundModel found_model)
    : private_handle_(private_handle), settings_(settings), group_(group), found_model_(std::move(found_model)) {
  advertise(private_handle, "reset", [this] {
    group_.reset();
    return fmt::format("{} components are reset: at rest, as new", group_.channels().size());
  });
  advertise(private_handle, "save_state", [this] { return save(); });
  advertise(private_handle, "load_state", [this] { return load(); });
  advertise(private_handle, "reload", [this] { return reload(); });
  advertiseSwitch(private_handle, "set_enabled", [this](bool enabled) { group_.setEnabled(enabled); });
  for (node::ComponentChannel* channel : group_.channels()) {
    advertise(handle, channel->name() + "/reset", [channel] {
      channel->reset();
      return channel->name() + " is reset: at rest, as new";
    });
    advertiseSwitch(handle, channel->name() + "/set_enabled",
                    [channel](bool enabled) { channel->setEnabled(enabled); });
    advertise(handle, channel->name() + "/promote", [this, channel] { return promote(*channel); });
    advertise(handle, channel->name() + "/rollback", [this, channel] {
      channel->rollBack();
      return fmt::format("back to the configured model within {:g} s of stamps", settings_.promotion.fade);
    });
  }
}

void NodeServices::advertise(ros::NodeHandle& handle, const std::string& name, std::function<std::string()> action) {
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> answer =
      [name, action = std::move(action)](Trigger::Request&, Trigger::Response& response) {
        try {
          response.message = action();
          response.success = 1U;
          ROS_INFO("%s: %s", name.c_str(), response.message.c_str());
        } catch (const std::exception& error) {
          response.message = error.what();
          response.success = 0U;
          ROS_ERROR("%s refused: %s", name.c_str(), error.what());
        }
        return true;
      };
  servers_.push_back(handle.advertiseService<Trigger::Request, Trigger::Response>(name, answer));
}

void NodeServices::advertiseSwitch(ros::NodeHandle& handle, const std::string& name,
                                   std::function<void(bool)> set_enabled) {
  const boost::function<bool(SetBool::Request&, SetBool::Response&)> answer =
      [name, set_enabled = std::move(set_enabled)](SetBool::Request& request, SetBool::Response& response) {
        set_enabled(request.data != 0U);
        response.success = 1U;
        response.message = request.data != 0U ? "enabled" : "disabled";
        ROS_INFO("%s: %s", name.c_str(), response.message.c_str());
        return true;
      };
  servers_.push_back(handle.advertiseService<SetBool::Request, SetBool::Response>(name, answer));
}

std::vector<std::string> NodeServices::names() const {
  std::vector<std::string> result;
  for (const ros::ServiceServer& server : servers_) {
    result.push_back(server.getService());
  }
  return result;
}

std::string NodeServices::save() const {
  requireStateFile(settings_);
  const std::vector<node::SavedState> states = group_.save();
  node::writeStateFile(settings_.state_file, states);
  return fmt::format("{} components saved to {}", states.size(), settings_.state_file);
}

std::string NodeServices::load() const {
  requireStateFile(settings_);
  loadStates(settings_.state_file, group_);
  return fmt::format("{} components loaded from {}", group_.channels().size(), settings_.state_file);
}

std::string NodeServices::reload() const {
  constexpr double kLimit = 1.0;  // [s]; the parameters are asked for without a limit, and hold up all services
  if (!masterAnswers(kLimit)) {
    throw std::runtime_error(fmt::format("the master, which holds the parameters, did not answer in {} s", kLimit));
  }
  const io::Cancellable cancellable(isEnding);
  exchangeModels(readComponents(private_handle_), settings_.max_gap, group_);
  return fmt::format("{} components reloaded", group_.channels().size());
}

std::string NodeServices::promote(node::ComponentChannel& channel) const {
  std::string source = settings_.promote_file;
  io::ComponentDescription model;
  if (source.empty()) {
    source = "what the live diagnosis found";
    model = found_model_(channel.name());
  } else {
    node::requireRegularFile(source);
    model = io::selectComponent(io::loadComponentFile(source), channel.name(), source);
  }
  channel.promote(model);
  return fmt::format("{}: in the shadow for {:g} s of stamps, then a cross-fade of {:g} s", source,
                     settings_.promotion.shadow, settings_.promotion.fade);
}

}  // namespace rubber_suspension::ros_interface
