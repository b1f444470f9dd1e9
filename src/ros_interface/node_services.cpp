// What a bench may ask of the node besides forces.
#include "ros_interface/node_services.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "node/state_file.h"

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

void loadStates(const std::string& path, const std::vector<node::ComponentChannel*>& channels) {
  const std::vector<node::SavedState> states = node::readStateFile(path);
  const auto name_of = [](const node::SavedState& state) -> const std::string& { return state.component; };
  const auto matched = matchByName(states, name_of, channels);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->checkState(*matched[i]);
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->load(*matched[i]);
  }
}

void exchangeModels(const std::vector<io::ComponentDescription>& descriptions, double max_gap,
                    const std::vector<node::ComponentChannel*>& channels) {
  const auto name_of = [](const io::ComponentDescription& description) -> const std::string& {
    return description.name;
  };
  std::vector<std::shared_ptr<node::ComponentChannel::Model>> models;
  for (const io::ComponentDescription* description : matchByName(descriptions, name_of, channels)) {
    models.push_back(node::ComponentChannel::makeModel(*description, max_gap));
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->exchange(models[i]);
  }
}

NodeServices::NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
                           const std::vector<node::ComponentChannel*>& channels)
    : private_handle_(private_handle), settings_(settings), channels_(channels) {
  advertise(private_handle, "reset", [this] {
    std::for_each(channels_.begin(), channels_.end(), [](node::ComponentChannel* channel) { channel->reset(); });
    return fmt::format("{} components are reset: at rest, as new", channels_.size());
  });
  advertise(private_handle, "save_state", [this] { return save(); });
  advertise(private_handle, "load_state", [this] { return load(); });
  advertise(private_handle, "reload", [this] { return reload(); });
  advertiseSwitch(private_handle, "set_enabled", channels_);
  for (node::ComponentChannel* channel : channels_) {
    advertise(handle, channel->name() + "/reset", [channel] {
      channel->reset();
      return channel->name() + " is reset: at rest, as new";
    });
    advertiseSwitch(handle, channel->name() + "/set_enabled", {channel});
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
                                   const std::vector<node::ComponentChannel*>& channels) {
  const boost::function<bool(SetBool::Request&, SetBool::Response&)> answer =
      [name, channels](SetBool::Request& request, SetBool::Response& response) {
        for (node::ComponentChannel* channel : channels) {
          channel->setEnabled(request.data != 0U);
        }
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
  std::vector<node::SavedState> states;
  for (const node::ComponentChannel* channel : channels_) {
    states.push_back(channel->save());
  }
  node::writeStateFile(settings_.state_file, states);
  return fmt::format("{} components saved to {}", states.size(), settings_.state_file);
}

std::string NodeServices::load() const {
  requireStateFile(settings_);
  loadStates(settings_.state_file, channels_);
  return fmt::format("{} components loaded from {}", channels_.size(), settings_.state_file);
}

std::string NodeServices::reload() const {
  exchangeModels(readComponents(private_handle_), settings_.max_gap, channels_);
  return fmt::format("{} components reloaded", channels_.size());
}

}  // namespace rubber_suspension::ros_interface
