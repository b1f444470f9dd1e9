// Client of the bundled topics.
#include "rubber_suspension/ros_interface/bundle_client.h"

#include <fmt/format.h>

#include "bag/header_stamp.h"
#include "element/refuse.h"
#include "ros_interface/connection.h"

namespace rubber_suspension::ros_interface {
namespace {

const char* topicOf(const DisplacementArray& /*message*/) { return "displacements"; }
const char* topicOf(const ForceArray& /*message*/) { return "forces"; }
const char* topicOf(const PoseArray& /*message*/) { return "poses"; }
const char* topicOf(const WrenchArray& /*message*/) { return "wrenches"; }

std::vector<double>& samplesOf(DisplacementArray& bundle) { return bundle.displacement; }
std::vector<geometry_msgs::Pose>& samplesOf(PoseArray& bundle) { return bundle.poses; }

}  // namespace

template <class Bundle, class Sample, class Answer>
BundleClientOf<Bundle, Sample, Answer>::BundleClientOf(const ros::NodeHandle& handle,
                                                       std::vector<std::string> components, double timeout)
    : handle_(handle), timeout_(timeout) {
  constexpr std::uint32_t kBundleQueueSize = 10000;
  handle_.setCallbackQueue(&queue_);
  message_.components.swap(components);
  publisher_ = handle_.advertise<Bundle>(topicOf(message_), kBundleQueueSize);
  const boost::function<void(const boost::shared_ptr<const Answer>&)> callback =
      [this](const boost::shared_ptr<const Answer>& answer) { answers_.push_back(*answer); };
  subscriber_ = handle_.subscribe<Answer>(topicOf(Answer()), kBundleQueueSize, callback, ros::VoidConstPtr(),
                                          ros::TransportHints().tcpNoDelay());
}

template <class Bundle, class Sample, class Answer>
void BundleClientOf<Bundle, Sample, Answer>::connect() {
  if (!waitForPublishers(subscriber_.getTopic(), timeout_) ||
      !waitFor(queue_, timeout_, [this] { return publisher_.getNumSubscribers() > 0; })) {
    throw BundleError(fmt::format("no node serves {} within {:g} s", publisher_.getTopic(), timeout_));
  }
}

template <class Bundle, class Sample, class Answer>
void BundleClientOf<Bundle, Sample, Answer>::call(const std::string& service) {
  const std::string refusal = callTrigger(handle_.resolveName(service), timeout_);
  element::refuseIf<BundleError>(!refusal.empty(), "{}", refusal);
}

template <class Bundle, class Sample, class Answer>
void BundleClientOf<Bundle, Sample, Answer>::send(std::int64_t stamp, const std::vector<Sample>& samples) {
  message_.header.stamp = bag::toRosTime(stamp);
  samplesOf(message_) = samples;
  publisher_.publish(message_);
}

template <class Bundle, class Sample, class Answer>
Answer BundleClientOf<Bundle, Sample, Answer>::receive(std::int64_t stamp) {
  const ros::Time time = bag::toRosTime(stamp);
  const bool came = waitFor(queue_, timeout_, [&] {
    while (!answers_.empty() && answers_.front().header.stamp < time) {
      answers_.pop_front();
    }
    return !answers_.empty();
  });
  if (!came || answers_.front().header.stamp != time) {
    throw BundleError(
        fmt::format("no answer on {} for stamp {} ns within {:g} s", subscriber_.getTopic(), stamp, timeout_));
  }
  const Answer& answer = answers_.front();
  if (answer.components != message_.components) {
    throw BundleError(fmt::format("{} of {} samples at {} ns were answered on {}; the others were dropped",
                                  answer.components.size(), message_.components.size(), stamp, subscriber_.getTopic()));
  }
  return answer;
}

template class BundleClientOf<DisplacementArray, double, ForceArray>;
template class BundleClientOf<PoseArray, geometry_msgs::Pose, WrenchArray>;

}  // namespace rubber_suspension::ros_interface
