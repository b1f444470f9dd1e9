// Server of the bundled topics.
#include "ros_interface/bundle_server.h"

#include <algorithm>

#include "node/message_bounds.h"
#include "ros_interface/pose_messages.h"

namespace rubber_suspension::ros_interface {
namespace {

using Channels = std::vector<node::ComponentChannel*>;

// Returns the channel with the i-th name, or nullptr if there is none. Without names, returns the i-th channel. Most
// senders name the components in the order of the file, so the i-th channel is tried first.
node::ComponentChannel* channelOf(const std::vector<std::string>& names, std::size_t i, const Channels& channels) {
  if (names.empty() || (i < channels.size() && channels[i]->name() == names[i])) {
    return channels[i];
  }
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const node::ComponentChannel* channel) { return channel->name() == names[i]; });
  return found == channels.end() ? nullptr : *found;
}

const std::vector<double>& samplesOf(const DisplacementArray& bundle) { return bundle.displacement; }
const std::vector<geometry_msgs::Pose>& samplesOf(const PoseArray& bundle) { return bundle.poses; }

template <class Bundle>
bool isWellFormed(const Bundle& bundle, const Channels& channels) {
  const std::size_t count = bundle.components.empty() ? channels.size() : bundle.components.size();
  if (samplesOf(bundle).size() != count || count > channels.size()) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (channelOf(bundle.components, i, channels) == nullptr) {
      return false;
    }
  }
  return true;
}

constexpr std::uint32_t kFewestBundles = 16;  // at least this number of bundles may wait, unless the queue is shorter

// Returns how many bundles may wait. Their total size is limited, since it grows with the number of components.
std::uint32_t fewerOf(std::uint32_t queue_size, std::size_t components, std::size_t numbers) {
  constexpr std::size_t kMostBytes = 64 * 1024 * 1024;
  const std::size_t fitting = kMostBytes / node::longestBundle(components, numbers);
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(fitting, kFewestBundles, queue_size));
}

void resize(ForceArray& answer, std::size_t size) {
  answer.components.resize(size);
  for (auto* list : {&answer.displacement, &answer.force, &answer.elastic, &answer.viscous, &answer.friction}) {
    list->resize(size);
  }
}

void resize(WrenchArray& answer, std::size_t size) {
  answer.components.resize(size);
  answer.wrenches.resize(size);
}

bool answerSample(node::ComponentChannel& channel, std::int64_t stamp, double displacement, ForceArray& answer,
                  std::size_t place) {
  element::ComponentForce force;
  if (!channel.push(stamp, displacement, force)) {
    return false;
  }
  answer.displacement[place] = displacement;
  answer.force[place] = force.total;
  answer.elastic[place] = force.elastic;
  answer.viscous[place] = force.viscous;
  answer.friction[place] = force.friction;
  return true;
}

bool answerSample(node::ComponentChannel& channel, std::int64_t stamp, const geometry_msgs::Pose& pose,
                  WrenchArray& answer, std::size_t place) {
  component::Wrench wrench;
  if (!channel.push(stamp, vectorOf(pose.position), rotationOf(pose), wrench)) {
    return false;
  }
  answer.wrenches[place] = messageOf(wrench);
  return true;
}

template <class Bundle, class Answer>
bool answerAll(const Bundle& bundle, const node::ChannelGroup& group, const Channels& channels, Answer& answer) {
  if (!isWellFormed(bundle, channels)) {
    return false;
  }
  const auto& samples = samplesOf(bundle);
  const auto stamp = static_cast<std::int64_t>(bundle.header.stamp.toNSec());
  answer.header = bundle.header;
  resize(answer, samples.size());
  std::size_t accepted = 0;
  const auto lock = group.bundle();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    node::ComponentChannel* channel = channelOf(bundle.components, i, channels);
    if (answerSample(*channel, stamp, samples[i], answer, accepted)) {
      answer.components[accepted] = channel->name();
      ++accepted;
    }
  }
  resize(answer, accepted);
  return true;
}

}  // namespace

bool answerBundle(const DisplacementArray& bundle, const node::ChannelGroup& group, ForceArray& answer) {
  return answerAll(bundle, group, group.channels(false), answer);
}

bool answerBundle(const PoseArray& bundle, const node::ChannelGroup& group, WrenchArray& answer) {
  return answerAll(bundle, group, group.channels(true), answer);
}

template <class Bundle, class Answer>
void BundleServer::serveBundles(ros::NodeHandle& handle, int queue_size, const std::string& in, std::size_t numbers_in,
                                const std::string& out, std::size_t numbers_out) {
  const std::size_t components = channels_.size();
  const auto size = static_cast<std::uint32_t>(queue_size);
  serve<Bundle, Answer>(
      *this, handle, in, std::min(size, fewerOf(std::max(size, kFewestBundles), components, numbers_in)),
      [components, numbers_in](const std::uint8_t* data, std::size_t bytes) {
        return node::isBundle(data, bytes, components, numbers_in);
      },
      out, fewerOf(answerQueueSize(queue_size), components, numbers_out));
}

BundleServer::BundleServer(ros::NodeHandle& handle, const node::ChannelGroup& group, int queue_size,
                           bool six_directions)
    : group_(group), channels_(group.channels(six_directions)) {
  constexpr std::size_t kForceNumbers = 5;  // displacement, force and its parts
  if (six_directions) {
    serveBundles<PoseArray, WrenchArray>(handle, queue_size, "poses", node::kPoseNumbers, "wrenches",
                                         node::kWrenchNumbers);
  } else {
    serveBundles<DisplacementArray, ForceArray>(handle, queue_size, "displacements", 1, "forces", kForceNumbers);
  }
}

template <class Bundle, class Answer>
bool BundleServer::answer(const Bundle& bundle, Answer& message) {
  const bool well_formed = answerBundle(bundle, group_, message);
  malformed_ += well_formed ? 0 : 1;
  return well_formed && !message.components.empty();  // no answer if every component has dropped its sample
}

template <class Answer>
void BundleServer::countAnswered(const Answer& message, std::int64_t latency) {
  ++answered_;
  for (std::size_t i = 0; i < message.components.size(); ++i) {
    channelOf(message.components, i, channels_)->countLatency(latency);
  }
}

}  // namespace rubber_suspension::ros_interface
