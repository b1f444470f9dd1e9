// The other end of the bundled topics.
#include "rubber_suspension/ros_interface/bundle_client.h"

#include <fmt/format.h>

#include <utility>

#include "bag/header_stamp.h"
#include "ros_interface/connection.h"

namespace rubber_suspension::ros_interface {
BundleClient::BundleClient(const ros::NodeHandle& handle, std::vector<std::string> components, double timeout)
    : handle_(handle), timeout_(timeout) {
  constexpr std::uint32_t kBundleQueueSize = 10000;
  handle_.setCallbackQueue(&queue_);
  message_.components = std::move(components);
  publisher_ = handle_.advertise<DisplacementArray>("displacements", kBundleQueueSize);
  const boost::function<void(const boost::shared_ptr<const ForceArray>&)> callback =
      [this](const boost::shared_ptr<const ForceArray>& answer) { answers_.push_back(*answer); };
  subscriber_ = handle_.subscribe<ForceArray>("forces", kBundleQueueSize, callback, ros::VoidConstPtr(),
                                              ros::TransportHints().tcpNoDelay());
}

void BundleClient::connect() {
  if (!waitForPublishers(subscriber_.getTopic(), timeout_) ||
      !waitFor(queue_, timeout_, [this] { return publisher_.getNumSubscribers() > 0; })) {
    throw BundleError(fmt::format("no node serves {} within {:g} s", publisher_.getTopic(), timeout_));
  }
}

void BundleClient::call(const std::string& service) {
  const std::string refusal = callTrigger(handle_.resolveName(service), timeout_);
  if (!refusal.empty()) {
    throw BundleError(refusal);
  }
}

void BundleClient::send(std::int64_t stamp, const std::vector<double>& displacement) {
  message_.header.stamp = bag::toRosTime(stamp);
  message_.displacement = displacement;
  publisher_.publish(message_);
}

ForceArray BundleClient::receive(std::int64_t stamp) {
  const ros::Time time = bag::toRosTime(stamp);
  const bool came = waitFor(queue_, timeout_, [&] {
    while (!answers_.empty() && answers_.front().header.stamp < time) {
      answers_.pop_front();
    }
    return !answers_.empty();
  });
  if (!came || answers_.front().header.stamp != time) {
    throw BundleError(fmt::format("no forces on {} for {} ns within {:g} s", subscriber_.getTopic(), stamp, timeout_));
  }
  const ForceArray& answer = answers_.front();
  if (answer.components != message_.components) {
    throw BundleError(fmt::format("{} of {} displacements at {} ns were answered on {}; the others were dropped",
                                  answer.components.size(), message_.components.size(), stamp, subscriber_.getTopic()));
  }
  return answer;
}

}  // namespace rubber_suspension::ros_interface
