// Loads of the components of a vehicle that steps at fixed times.
#include "vehicle/force_exchange.h"

#include "element/refuse.h"

namespace rubber_suspension::vehicle {
namespace {

component::StreamForce pushInto(component::SampleStream& stream, std::int64_t stamp, double displacement) {
  return stream.push(stamp, displacement);
}

component::StreamWrench pushInto(component::PoseStream& stream, std::int64_t stamp, const Eigen::Isometry3d& pose) {
  return stream.push(stamp, pose.translation(), Eigen::Quaterniond(pose.linear()));
}

void take(const component::StreamForce& answer, std::size_t i, PerStrut& loads) { loads[i] = answer.force.total; }

void take(const component::StreamWrench& answer, std::size_t /*i*/, PerBush<component::Wrench>& loads) {
  loads.push_back(answer.force.wrench);
}

}  // namespace

template <class Stream, class Motions, class Loads>
void StreamExchange<Stream, Motions, Loads>::send(std::int64_t stamp, const Motions& motions) {
  Answer answer{stamp, {}};
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    const auto result = pushInto(streams_[i], stamp, motions[i]);
    element::refuseIf<std::runtime_error>(!component::isAccepted(result.acceptance),
                                          "the motion of component {} at {} ns was not accepted", i + 1, stamp);
    take(result, i, answer.loads);
  }
  answers_.push_back(answer);
}

template <class Stream, class Motions, class Loads>
Loads StreamExchange<Stream, Motions, Loads>::receive(std::int64_t stamp) {
  while (!answers_.empty() && answers_.front().stamp < stamp) {
    answers_.pop_front();
  }
  element::refuseIf<std::runtime_error>(answers_.empty() || answers_.front().stamp != stamp,
                                        "no displacement was sent at {} ns", stamp);
  return answers_.front().loads;
}

template class StreamExchange<component::SampleStream, PerStrut, PerStrut>;
template class StreamExchange<component::PoseStream, PerBush<Eigen::Isometry3d>, PerBush<component::Wrench>>;

}  // namespace rubber_suspension::vehicle
