// Services of the node.
#include "ros_interface/node_services.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/console.h>
#include <rubber_suspension/EnableComponent.h>
#include <rubber_suspension/ResetComponent.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "io/cancellation.h"
#include "node/regular_file.h"
#include "node/state_file.h"
#include "ros_interface/master.h"
#include "ros_interface/process_fixes.h"
#include "ros_interface/termination.h"

namespace rubber_suspension::ros_interface {
namespace {

// Returns the channel with this name. Throws std::invalid_argument, which lists all names, if there is none.
node::ComponentChannel& channelNamed(const std::string& name, const node::ChannelGroup& group) {
  std::vector<std::string> names;
  for (node::ComponentChannel* channel : group.channels()) {
    if (channel->name() == name) {
      return *channel;
    }
    names.push_back(channel->name());
  }
  throw std::invalid_argument(fmt::format("this node has no component '{}'{}; accepted: {}", name,
                                          element::didYouMean(name, names), fmt::join(names, ", ")));
}

// Returns for every channel the entry with its name. Throws unless entries and channels have the same names.
template <class Entry>
std::vector<const Entry*> matchByName(const std::vector<Entry>& entries, std::string Entry::* name,
                                      const node::ChannelGroup& group) {
  for (const Entry& entry : entries) {
    channelNamed(entry.*name, group);
  }
  std::vector<const Entry*> matched;
  for (const node::ComponentChannel* channel : group.channels()) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.*name == channel->name(); });
    if (found == entries.end()) {
      throw std::invalid_argument(fmt::format("component {} of this node is missing", channel->name()));
    }
    matched.push_back(&*found);
  }
  return matched;
}

const std::string& stateFileOf(const NodeSettings& settings) {
  return settings.state_file.empty() ? throw std::invalid_argument("the parameter ~state_file is not set")
                                     : settings.state_file;
}

}  // namespace

void loadStates(const std::string& path, node::ChannelGroup& group) {
  const std::vector<node::SavedState> states = node::readStateFile(path);
  group.load(matchByName(states, &node::SavedState::component, group));
}

NodeServices::NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
                           node::ChannelGroup& group, const LiveDiagnoser* live)
    : handle_(handle), private_handle_(private_handle), settings_(settings), group_(group), live_(live) {
  using std_srvs::SetBool;
  using std_srvs::Trigger;
  advertise<Trigger>(private_handle_, "reset", [this](const Trigger::Request&) {
    group_.reset();
    return fmt::format("{} components were reset; they are at rest and as new", group_.channels().size());
  });
  advertise<Trigger>(private_handle_, "save_state", [this](const Trigger::Request&) { return save(); });
  advertise<Trigger>(private_handle_, "load_state", [this](const Trigger::Request&) { return load(); });
  advertise<Trigger>(private_handle_, "reload", [this](const Trigger::Request&) { return reload(); });
  advertise<SetBool>(private_handle_, "set_enabled", [this](const SetBool::Request& request) {
    group_.setEnabled(request.data != 0U);
    return std::string(request.data != 0U ? "enabled" : "disabled");
  });
  advertise<ResetComponent>(private_handle_, "reset_component", [this](const ResetComponent::Request& request) {
    channelNamed(request.component, group_).reset();
    return request.component + " was reset; it is at rest and as new";
  });
  advertise<EnableComponent>(private_handle_, "enable_component", [this](const EnableComponent::Request& request) {
    channelNamed(request.component, group_).setEnabled(request.data != 0U);
    return request.component + (request.data != 0U ? " is enabled" : " is disabled");
  });
  advertisePromotions();
}

// Advertises the services of each component for which a model can be promoted or has been promoted in a loaded state.
void NodeServices::advertisePromotions() {
  using std_srvs::Trigger;
  for (node::ComponentChannel* channel : group_.channels()) {
    const bool promotable = !channel->hasSixDirections() && (settings_.diagnose || !settings_.promote_file.empty() ||
                                                             !channel->running().other_sha256.empty());
    if (!promotable || !promotable_.insert(channel->name()).second) {
      continue;
    }
    io::checkCancelled();
    advertise<Trigger>(handle_, channel->name() + "/promote",
                       [this, channel](const Trigger::Request&) { return promote(*channel); });
    advertise<Trigger>(handle_, channel->name() + "/rollback", [this, channel](const Trigger::Request&) {
      channel->rollBack();
      return fmt::format("returns to the configured model within {:g} s, by the stamps", settings_.promotion.fade);
    });
  }
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
  std::vector<std::string> result = loggerServices();
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const ros::ServiceServer& server : servers_) {
    result.push_back(server.getService());
  }
  return result;
}

std::string NodeServices::save() const {
  const std::vector<node::SavedState> states = group_.save();
  node::writeStateFile(stateFileOf(settings_), states);
  return fmt::format("{} components saved to {}", states.size(), settings_.state_file);
}

std::string NodeServices::load() {
  loadStates(stateFileOf(settings_), group_);
  advertisePromotions();
  return fmt::format("{} components loaded from {}", group_.channels().size(), settings_.state_file);
}

std::string NodeServices::reload() const {
  constexpr double kLimit = 1.0;  // [s]; roscpp requests parameters without a limit, which would block all services
  element::refuseIf<std::runtime_error>(!masterAnswers(kLimit), "the master did not return the parameters within {} s",
                                        kLimit);
  const io::Cancellable cancellable(isEnding);
  const std::vector<io::ComponentDescription> described = readComponents(private_handle_, settings_);
  std::vector<std::shared_ptr<node::ComponentChannel::Model>> models;
  for (const io::ComponentDescription* description : matchByName(described, &io::ComponentDescription::name, group_)) {
    if (channelNamed(description->name, group_).hasSixDirections() != (description->six != nullptr)) {
      throw std::invalid_argument(fmt::format("component {} now has {}; this change needs a restart", description->name,
                                              description->six ? "six directions" : "one direction"));
    }
    models.push_back(node::ComponentChannel::makeModel(*description, settings_.max_gap));
  }
  group_.exchange(models);
  return fmt::format("{} components reloaded", models.size());
}

std::string NodeServices::promote(node::ComponentChannel& channel) const {
  std::string source = settings_.promote_file;
  io::ComponentDescription model;
  element::refuseIf(source.empty() && live_ == nullptr,
                    "{}: there is no model to promote: set ~promote_file or ~diagnose", channel.name());
  if (source.empty()) {
    source = "the model of the live diagnosis";
    model = live_->found(channel.name());
  } else {
    node::requireRegularFile(source);
    model = io::selectComponent(io::loadComponentFile(source), channel.name(), source);
    model = settings_.without_rig ? model.withoutRig() : model;
  }
  channel.promote(model);
  return fmt::format("{}: runs in the shadow for {:g} s, by the stamps; then a cross-fade of {:g} s follows", source,
                     settings_.promotion.shadow, settings_.promotion.fade);
}

}  // namespace rubber_suspension::ros_interface
