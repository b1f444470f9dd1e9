// Faults for a node that the driver of this folder must not let pass; compiled into a program of the tests only.
#pragma once

#include <rubber_suspension/Force.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "node/component_channel.h"
#include "ros_interface/answer_publisher.h"

namespace rubber_suspension::wire_test {

/// Do to one force in 100,000 what the environment variable MUTANT says: `twice`, `none`, `ulp` or `count`; with `leak`
/// 16 bytes are lost with every force. False where the force is not to be published.
inline bool mutate(node::ComponentChannel& channel, const boost::shared_ptr<Force>& message,
                   ros_interface::AnswerPublisher& publisher) {
  constexpr std::uint64_t kPeriod = 100000;
  static const std::string fault = std::getenv("MUTANT") == nullptr ? "" : std::getenv("MUTANT");
  static std::atomic<std::uint64_t> number{kPeriod / 2};
  if (fault == "leak") {
    static volatile char* kept = nullptr;
    kept = static_cast<char*>(std::malloc(16));
    *kept = 1;
    return true;
  }
  if (++number % kPeriod != 0) {
    return true;
  }
  if (fault == "twice") {
    publisher.publish(message);
  } else if (fault == "ulp") {
    message->force = std::nextafter(message->force, std::numeric_limits<double>::infinity());
  } else if (fault == "count") {
    channel.countLost(1);
  }
  return fault != "none";
}

}  // namespace rubber_suspension::wire_test
