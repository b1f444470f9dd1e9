// All components in one message.
#include "ros_interface/bundle_server.h"

#include <algorithm>
#include <chrono>

#include "node/message_bounds.h"
#include "ros_interface/sample_server.h"
#include "roscpp_fixes/checked_subscription.h"

namespace rubber_suspension::ros_interface {
namespace {

// The channel of a name that stands at place i. Senders name the components in the order of the file, mostly: look
// there first.
node::ComponentChannel* channelNamed(const std::string& name, std::size_t i,
                                     const std::vector<node::ComponentChannel*>& channels) {
  if (i < channels.size() && channels[i]->name() == name) {
    return channels[i];
  }
  for (node::ComponentChannel* channel : channels) {
    if (channel->name() == name) {
      return channel;
    }
  }
  return nullptr;
}

// The channel of entry i.
node::ComponentChannel* channelOf(const DisplacementArray& bundle, std::size_t i,
                                  const std::vector<node::ComponentChannel*>& channels) {
  return bundle.components.empty() ? channels[i] : channelNamed(bundle.components[i], i, channels);
}

bool isWellFormed(const DisplacementArray& bundle, const std::vector<node::ComponentChannel*>& channels) {
  const std::size_t count = bundle.components.empty() ? channels.size() : bundle.components.size();
  if (bundle.displacement.size() != count || count > channels.size()) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (channelOf(bundle, i, channels) == nullptr) {
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

std::size_t longestAnswer(std::size_t components) {
  return node::longestBundle(components) + components * 4 * sizeof(double);
}

void resize(ForceArray& answer, std::size_t size) {
  answer.components.resize(size);
  for (auto* list : {&answer.displacement, &answer.force, &answer.elastic, &answer.viscous, &answer.friction}) {
    list->resize(size);
  }
}

}  // namespace

bool answerBundle(const DisplacementArray& bundle, const node::ChannelGroup& group, ForceArray& answer) {
  const std::vector<node::ComponentChannel*>& channels = group.channels();
  if (!isWellFormed(bundle, channels)) {
    return false;
  }
  const auto stamp = static_cast<std::int64_t>(bundle.header.stamp.toNSec());
  answer.header = bundle.header;
  resize(answer, bundle.displacement.size());
  std::size_t accepted = 0;
  const auto lock = group.bundle();
  for (std::size_t i = 0; i < bundle.displacement.size(); ++i) {
    node::ComponentChannel* channel = channelOf(bundle, i, channels);
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
  const auto size = static_cast<std::uint32_t>(std::max(queue_size, 16));
  publisher_.advertise<ForceArray>(handle, "forces", fewerOf(answerQueueSize(queue_size), longestAnswer(components)));
  subscriber_ = roscpp_fixes::subscribeChecked<DisplacementArray>(
      handle, "displacements",
      std::min<std::uint32_t>(static_cast<std::uint32_t>(queue_size), fewerOf(size, node::longestBundle(components))),
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
    channelNamed(message->components[i], i, group_.channels())->countLatency(latency);
  }
}

}  // namespace rubber_suspension::ros_interface
