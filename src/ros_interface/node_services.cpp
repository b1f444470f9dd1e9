// What a bench may ask of the node besides forces.
#include "ros_interface/node_services.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/console.h>
#include <rubber_suspension/EnableComponent.h>
#include <rubber_suspension/ResetComponent.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include "element/suggestion.h"
#include "io/cancellation.h"
#include "node/regular_file.h"
#include "node/state_file.h"
#include "ros_interface/termination.h"
#include "roscpp_fixes/master_call.h"

namespace rubber_suspension::ros_interface {
namespace {

// The entry of that name, as all the lists here are small and unsorted.
template <class Entries, class Name>
auto findNamed(const Entries& entries, Name name_of, const std::string& name) {
  return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return name_of(entry) == name; });
}

std::string nameOf(const node::ComponentChannel* channel) { return channel->name(); }

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
    if (findNamed(channels, nameOf, name) == channels.end()) {
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
    : handle_(handle),
      private_handle_(private_handle),
      settings_(settings),
      group_(group),
      found_model_(std::move(found_model)) {
  advertiseForAll();
  advertise<ResetComponent>(private_handle_, "reset_component", [this](const ResetComponent::Request& request) {
    at(request.component).reset();
    return request.component + " is reset: at rest, as new";
  });
  advertise<EnableComponent>(private_handle_, "enable_component", [this](const EnableComponent::Request& request) {
    at(request.component).setEnabled(request.data != 0U);
    return request.component + (request.data != 0U ? " is enabled" : " is disabled");
  });
  advertisePromotions();
}

void NodeServices::advertiseForAll() {
  using std_srvs::SetBool;
  using std_srvs::Trigger;
  advertise<Trigger>(private_handle_, "reset", [this](const Trigger::Request&) {
    group_.reset();
    return fmt::format("{} components are reset: at rest, as new", group_.channels().size());
  });
  advertise<Trigger>(private_handle_, "save_state", [this](const Trigger::Request&) { return save(); });
  advertise<Trigger>(private_handle_, "load_state", [this](const Trigger::Request&) { return load(); });
  advertise<Trigger>(private_handle_, "reload", [this](const Trigger::Request&) { return reload(); });
  advertise<SetBool>(private_handle_, "set_enabled", [this](const SetBool::Request& request) {
    group_.setEnabled(request.data != 0U);
    return std::string(request.data != 0U ? "enabled" : "disabled");
  });
}

// Of each component that a model can be promoted for, or that has a promoted one from a state that was loaded.
void NodeServices::advertisePromotions() {
  for (node::ComponentChannel* channel : group_.channels()) {
    if (settings_.diagnose || !settings_.promote_file.empty() || !channel->running().other_sha256.empty()) {
      advertisePromotion(*channel);
    }
  }
}

void NodeServices::advertisePromotion(node::ComponentChannel& channel) {
  using std_srvs::Trigger;
  if (!promotable_.insert(channel.name()).second) {
    return;
  }
  advertise<Trigger>(handle_, channel.name() + "/promote",
                     [this, &channel](const Trigger::Request&) { return promote(channel); });
  advertise<Trigger>(handle_, channel.name() + "/rollback", [this, &channel](const Trigger::Request&) {
    channel.rollBack();
    return fmt::format("back to the configured model within {:g} s of stamps", settings_.promotion.fade);
  });
}

template <class Service, class Action>
void NodeServices::advertise(ros::NodeHandle& handle, const std::string& name, Action action) {
  const boost::function<bool(typename Service::Request&, typename Service::Response&)> answer =
      [name, action = std::move(action)](typename Service::Request& request, typename Service::Response& response) {
        try {
          response.message = action(request);
          response.success = 1U;
          ROS_INFO("%s: %s", name.c_str(), response.message.c_str());
        } catch (const std::exception& error) {
          response.message = error.what();
          response.success = 0U;
          ROS_ERROR("%s refused: %s", name.c_str(), error.what());
        }
        return true;
      };
  const ros::ServiceServer server =
      handle.advertiseService<typename Service::Request, typename Service::Response>(name, answer);
  const std::lock_guard<std::mutex> lock(mutex_);
  servers_.push_back(server);
}

std::vector<std::string> NodeServices::names() const {
  std::vector<std::string> result;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const ros::ServiceServer& server : servers_) {
    result.push_back(server.getService());
  }
  return result;
}

node::ComponentChannel& NodeServices::at(const std::string& component) const {
  const auto& channels = group_.channels();
  const auto found = findNamed(channels, nameOf, component);
  if (found == channels.end()) {
    std::vector<std::string> names;
    std::transform(channels.begin(), channels.end(), std::back_inserter(names), nameOf);
    throw std::invalid_argument(fmt::format("no component '{}'{}; accepted: {}", component,
                                            element::didYouMean(component, names), fmt::join(names, ", ")));
  }
  return **found;
}

std::string NodeServices::save() const {
  requireStateFile(settings_);
  const std::vector<node::SavedState> states = group_.save();
  node::writeStateFile(settings_.state_file, states);
  return fmt::format("{} components saved to {}", states.size(), settings_.state_file);
}

std::string NodeServices::load() {
  requireStateFile(settings_);
  loadStates(settings_.state_file, group_);
  advertisePromotions();
  return fmt::format("{} components loaded from {}", group_.channels().size(), settings_.state_file);
}

std::string NodeServices::reload() const {
  constexpr double kLimit = 1.0;  // [s]; the parameters are asked for without a limit, and hold up all services
  if (!roscpp_fixes::masterAnswers(kLimit)) {
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
