// A publisher that knows what became of its messages: roscpp's own drops those that a subscriber is too slow for, and
// says nothing.
#pragma once

#include <ros/advertise_options.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/topic_manager.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace rubber_suspension::ros_interface {

class AnswerCount;
class SubscriberWatch;

/// Publishes from one thread, any one. A burst waits here for roscpp's network thread to take it over, instead of
/// running over what may wait for a subscriber: one that reads what it is sent gets every message.
class AnswerPublisher {
 public:
  AnswerPublisher();
  ~AnswerPublisher();
  AnswerPublisher(const AnswerPublisher&) = delete;
  AnswerPublisher& operator=(const AnswerPublisher&) = delete;

  /// `queue_size`: messages that may wait for each subscriber before its oldest is lost, at least 2.
  template <class Message>
  void advertise(ros::NodeHandle& handle, const std::string& topic, std::uint32_t queue_size) {
    // A subscriber that was there before the losses are watched comes again.
    constexpr int kAttempts = 5;
    bool watched = false;
    for (int attempt = 0; attempt < kAttempts && !watched; ++attempt) {
      shutdown();
      ros::AdvertiseOptions options;
      options.template init<Message>(topic, queue_size);
      watchSubscribers(options);
      publisher_ = handle.advertise(options);
      watched = watch(queue_size);
    }
  }

  /// The message must not be changed any more while others hold it.
  template <class Message>
  void publish(const boost::shared_ptr<Message>& message) {
    if (!hasSubscribers()) {
      return;
    }
    ros::SerializedMessage serialized;
    serialized.type_info = &typeid(Message);
    serialized.message = message;
    send([&message, this] { return serialize(*message); }, serialized);
  }

  /// Messages that at least one subscriber did not get because too many were waiting for it. Those that a subscriber
  /// did not read before it went are not among them.
  std::uint64_t undelivered() const;

  /// The same for each subscriber that lost any, by the name of its node, of all its connections together. roscpp's own
  /// statistics say nothing of it: what they call sent is what was put into a queue.
  std::map<std::string, std::uint64_t> undeliveredTo() const;

  void shutdown();

 private:
  void watchSubscribers(ros::AdvertiseOptions& options) const;
  bool watch(std::uint32_t queue_size);
  bool hasSubscribers();
  void send(const boost::function<ros::SerializedMessage()>& serialized, ros::SerializedMessage& message);
  ros::SerializedMessage makeBuffer(std::uint32_t size);

  template <class Message>
  ros::SerializedMessage serialize(const Message& message) {
    const std::uint32_t size = ros::serialization::serializationLength(message);
    ros::SerializedMessage result = makeBuffer(size);
    ros::serialization::OStream stream(result.message_start, size);
    ros::serialization::serialize(stream, message);
    return result;
  }

  std::shared_ptr<SubscriberWatch> subscriber_watch_;  // before the publisher, which refers to it
  ros::Publisher publisher_;
  ros::PublicationPtr publication_;
  std::shared_ptr<AnswerCount> count_;
};

}  // namespace rubber_suspension::ros_interface
