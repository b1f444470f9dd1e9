// A fault in the node that the driver in this folder must detect. A test program includes this file first, so that it
// replaces the publishers of the node.
#pragma once

#include <rubber_suspension/Force.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <type_traits>

#include "ros_interface/answer_publisher.h"

namespace rubber_suspension::ros_interface {

/// Applies the fault named by the environment variable MUTANT to one force in 100,000: `twice`, `none`, `ulp` or
/// `count`. The fault `leak` leaks 16 bytes with every force.
class MutantPublisher : public AnswerPublisher {
 public:
  template <class Message>
  void publish(const boost::shared_ptr<Message>& message) {
    if constexpr (std::is_same_v<Message, Force>) {
      if (!mutate(message)) {
        return;
      }
    }
    AnswerPublisher::publish(message);
  }

  std::uint64_t undelivered() const { return AnswerPublisher::undelivered() + miscounted_; }

 private:
  // Returns false if the force must not be published.
  bool mutate(const boost::shared_ptr<Force>& message) {
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
      AnswerPublisher::publish(message);
    } else if (fault == "ulp") {
      message->force = std::nextafter(message->force, std::numeric_limits<double>::infinity());
    } else if (fault == "count") {
      ++miscounted_;
    }
    return fault != "none";
  }

  std::atomic<std::uint64_t> miscounted_{0};
};

}  // namespace rubber_suspension::ros_interface

#define AnswerPublisher MutantPublisher
