// A topic of samples and the topic of their answers, for one component or for bundles of all components.
#pragma once

#include <ros/node_handle.h>
#include <ros/subscription_callback_helper.h>

#include <algorithm>
#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "node/sequence_watch.h"
#include "ros_interface/answer_publisher.h"
#include "ros_interface/message_pool.h"

namespace rubber_suspension::ros_interface {

/// A function that returns true if the bytes are a message of the topic.
using MessageCheck = std::function<bool(const std::uint8_t* data, std::size_t size)>;

/// Decodes messages that pass the check and counts the other messages. Without the check, roscpp would allocate as many
/// entries as a message claims to have, and log a line for each message that it cannot decode.
template <class Message>
class CheckedCallback : public ros::SubscriptionCallbackHelperT<const ros::MessageEvent<const Message>&> {
 public:
  using Base = ros::SubscriptionCallbackHelperT<const ros::MessageEvent<const Message>&>;

  CheckedCallback(const typename Base::Callback& callback, MessageCheck check, std::atomic<std::uint64_t>& refused)
      : Base(callback), check_(std::move(check)), refused_(refused) {}

  ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& params) override {
    if (!check_(params.buffer, params.length)) {
      ++refused_;
      return {};
    }
    return Base::deserialize(params);
  }

 private:
  MessageCheck check_;
  std::atomic<std::uint64_t>& refused_;
};

/// Answers samples in the thread that serves the handle's callback queue. Allocates nothing itself once its messages
/// exist. Waits only while answers that fill more than half a queue wait for the network thread.
class AnsweringTopics {
 public:
  void shutdown() {
    subscribers_.clear();
    publisher_.shutdown();
  }

  std::uint64_t undecodable() const { return undecodable_; }              ///< number of messages of another type
  std::uint64_t undelivered() const { return publisher_.undelivered(); }  ///< number of lost answers

 protected:
  /// Passes messages of the topic to `take`. TCP sends them without delay (TCP_NODELAY).
  template <class Message>
  void subscribe(ros::NodeHandle& handle, const std::string& topic, std::uint32_t queue_size, MessageCheck check,
                 const boost::function<void(const ros::MessageEvent<const Message>&)>& take) {
    ros::SubscribeOptions options(topic, queue_size, ros::message_traits::md5sum<Message>(),
                                  ros::message_traits::datatype<Message>());
    options.helper = boost::make_shared<CheckedCallback<Message>>(take, std::move(check), undecodable_);
    options.transport_hints = ros::TransportHints().tcpNoDelay();
    subscribers_.push_back(handle.subscribe(options));
  }

  /// Answers samples of the topic `in` on the topic `out`. The server has three functions: countLost(number of samples
  /// that did not arrive), answer(sample, message to fill), which returns false if there is no answer, and
  /// countAnswered(message, latency [ns]).
  template <class Sample, class Answer, class Server>
  void serve(Server& server, ros::NodeHandle& handle, const std::string& in, std::uint32_t in_size, MessageCheck check,
             const std::string& out, std::uint32_t out_size) {
    publisher_.advertise<Answer>(handle, out, out_size);
    subscribe<Sample>(handle, in, in_size, std::move(check),
                      [this, &server, pool = std::make_shared<MessagePool<Answer>>()](
                          const ros::MessageEvent<const Sample>& event) { answer(server, event, *pool); });
  }

  /// Returns how many answers may wait for a slow subscriber. This number exceeds the number of samples that may wait
  /// on the input, so that the answers to accepted samples are not lost.
  static std::uint32_t answerQueueSize(int queue_size) {
    constexpr std::uint32_t kFewest = 40000;
    return std::max(kFewest, 4 * static_cast<std::uint32_t>(queue_size));
  }

 private:
  using Clock = std::chrono::steady_clock;

  template <class Sample, class Answer, class Server>
  void answer(Server& server, const ros::MessageEvent<const Sample>& event, MessagePool<Answer>& pool) {
    const auto callback = Clock::now();
    const Sample& sample = *event.getConstMessage();
    if (const std::uint32_t lost = watch_.take(event.getConnectionHeaderPtr(), sample.header.seq)) {
      server.countLost(lost);
    }
    const auto message = pool.take();
    if (server.answer(sample, *message)) {
      publisher_.publish(message);
      server.countAnswered(*message, sinceArrival(event.getReceiptTime(), callback));
    }
  }

  // Returns the time since the arrival of a message [ns]. ROS stamps arrivals with ros::Time. If this time is
  // simulated, the time since the start of the callback is returned instead.
  static std::int64_t sinceArrival(const ros::Time& receipt, Clock::time_point callback) {
    return ros::Time::isSystemTime()
               ? std::max<std::int64_t>(0, (ros::Time::now() - receipt).toNSec())
               : std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - callback).count();
  }

  node::SequenceWatch<boost::shared_ptr<ros::M_string>> watch_;
  std::atomic<std::uint64_t> undecodable_{0};
  AnswerPublisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rubber_suspension::ros_interface
