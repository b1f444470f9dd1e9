// Forces of the components of a vehicle that steps at fixed times.
#include "vehicle/force_exchange.h"

#include <fmt/format.h>

#include <stdexcept>

namespace rubber_suspension::vehicle {

LibraryExchange::LibraryExchange(const std::vector<component::Component>& components) {
  for (const component::Component& component : components) {
    streams_.emplace_back(component);
  }
}

void LibraryExchange::send(std::int64_t stamp, const PerStrut& displacement) {
  Answer answer{stamp, {}};
  for (std::size_t i = 0; i < kStruts; ++i) {
    const component::StreamForce result = streams_[i].push(stamp, displacement[i]);
    if (!component::isAccepted(result.acceptance)) {
      throw std::runtime_error(
          fmt::format("{}: displacement {:g} m at {} ns was not accepted", strutNames()[i], displacement[i], stamp));
    }
    answer.force[i] = result.force.total;
  }
  answers_.push_back(answer);
}

PerStrut LibraryExchange::receive(std::int64_t stamp) {
  while (!answers_.empty() && answers_.front().stamp < stamp) {
    answers_.pop_front();
  }
  if (answers_.empty() || answers_.front().stamp != stamp) {
    throw std::runtime_error(fmt::format("no displacement was sent at {} ns", stamp));
  }
  return answers_.front().force;
}

}  // namespace rubber_suspension::vehicle
