// A publisher that knows what became of its messages: roscpp's own drops those that a subscriber is too slow for, and
// says nothing.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/topic_manager.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace rubber_suspension::ros_interface {

class AnswerCount;

/// Publishes from one thread, any one. A burst waits here for roscpp's network thread to take it over, instead of
/// running over what may wait for a subscriber: one that reads what it is sent gets every message.
class AnswerPublisher {
 public:
  AnswerPublisher() = default;
  ~AnswerPublisher() { shutdown(); }
  AnswerPublisher(const AnswerPublisher&) = delete;
  AnswerPublisher& operator=(const AnswerPublisher&) = delete;

  /// `queue_size`: messages that may wait for each subscriber before its oldest is lost, at least 2.
  template <class Message>
  void advertise(ros::NodeHandle& handle, const std::string& topic, std::uint32_t queue_size) {
    publisher_ = handle.advertise<Message>(topic, queue_size);
    watch(queue_size);
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

  void shutdown();

 private:
  void watch(std::uint32_t queue_size);
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

  ros::Publisher publisher_;
  ros::PublicationPtr publication_;
  std::shared_ptr<AnswerCount> count_;
};

}  // namespace rubber_suspension::ros_interface
