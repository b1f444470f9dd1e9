// All components in one message.
#include "ros_interface/bundle_server.h"

#include <algorithm>
#include <chrono>

#include "node/message_bounds.h"
#include "ros_interface/sample_server.h"
#include "roscpp_fixes/checked_subscription.h"

namespace rubber_suspension::ros_interface {
namespace {

using Channels = std::vector<node::ComponentChannel*>;

// The channel of the name at place i; without names, of that place. Senders name the components in the order of the
// file, mostly: look there first.
node::ComponentChannel* channelOf(const std::vector<std::string>& names, std::size_t i, const Channels& channels) {
  if (names.empty() || (i < channels.size() && channels[i]->name() == names[i])) {
    return channels[i];
  }
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const node::ComponentChannel* channel) { return channel->name() == names[i]; });
  return found == channels.end() ? nullptr : *found;
}

bool isWellFormed(const DisplacementArray& bundle, const Channels& channels) {
  const std::size_t count = bundle.components.empty() ? channels.size() : bundle.components.size();
  if (bundle.displacement.size() != count || count > channels.size()) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (channelOf(bundle.components, i, channels) == nullptr) {
      return false;
    }
  }
  return true;
}

// Bundles are as long as there are components: fewer may wait than single samples where there are many.
std::uint32_t fewerOf(std::uint32_t queue_size, std::size_t bytes) {
  constexpr std::size_t kMostBytes = 64 * 1024 * 1024;
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(kMostBytes / bytes, 16, queue_size));
}

void resize(ForceArray& answer, std::size_t size) {
  answer.components.resize(size);
  for (auto* list : {&answer.displacement, &answer.force, &answer.elastic, &answer.viscous, &answer.friction}) {
    list->resize(size);
  }
}

}  // namespace

bool answerBundle(const DisplacementArray& bundle, const node::ChannelGroup& group, ForceArray& answer) {
  const Channels& channels = group.channels();
  if (!isWellFormed(bundle, channels)) {
    return false;
  }
  const auto stamp = static_cast<std::int64_t>(bundle.header.stamp.toNSec());
  answer.header = bundle.header;
  resize(answer, bundle.displacement.size());
  std::size_t accepted = 0;
  const auto lock = group.bundle();
  for (std::size_t i = 0; i < bundle.displacement.size(); ++i) {
    node::ComponentChannel* channel = channelOf(bundle.components, i, channels);
    element::ComponentForce force;
    if (channel->push(stamp, bundle.displacement[i], force)) {
      answer.components[accepted] = channel->name();
      answer.displacement[accepted] = bundle.displacement[i];
      answer.force[accepted] = force.total;
      answer.elastic[accepted] = force.elastic;
      answer.viscous[accepted] = force.viscous;
      answer.friction[accepted] = force.friction;
      ++accepted;
    }
  }
  resize(answer, accepted);
  return true;
}

BundleServer::BundleServer(ros::NodeHandle& handle, const node::ChannelGroup& group, int queue_size) : group_(group) {
  const std::size_t components = group.channels().size();
  const std::size_t longest = node::longestBundle(components);
  const auto size = static_cast<std::uint32_t>(std::max(queue_size, 16));
  publisher_.advertise<ForceArray>(handle, "forces",
                                   fewerOf(answerQueueSize(queue_size), longest + components * 4 * sizeof(double)));
  subscriber_ = roscpp_fixes::subscribeChecked<DisplacementArray>(
      handle, "displacements", std::min<std::uint32_t>(static_cast<std::uint32_t>(queue_size), fewerOf(size, longest)),
      [components](const std::uint8_t* data, std::size_t bytes) { return node::isBundle(data, bytes, components); },
      undecodable_, [this](const ros::MessageEvent<const DisplacementArray>& event) { serve(event); });
}

void BundleServer::shutdown() {
  subscriber_.shutdown();
  publisher_.shutdown();
}

void BundleServer::serve(const ros::MessageEvent<const DisplacementArray>& event) {
  const auto callback = std::chrono::steady_clock::now();
  lost_ += watch_.take(event.getConnectionHeaderPtr(), event.getConstMessage()->header.seq);
  const auto message = pool_.take();
  if (!answerBundle(*event.getConstMessage(), group_, *message)) {
    ++malformed_;
    return;
  }
  if (message->components.empty()) {
    return;  // every sample was dropped and counted by its component
  }
  publisher_.publish(message);
  ++answered_;
  const std::int64_t latency = timeSinceArrival(event.getReceiptTime(), callback);
  for (std::size_t i = 0; i < message->components.size(); ++i) {
    channelOf(message->components, i, group_.channels())->countLatency(latency);
  }
}

}  // namespace rubber_suspension::ros_interface
