// A publisher that loses no message of a burst, and counts the messages that slow subscribers lose. roscpp's own
// publisher drops such messages silently.
#pragma once

#include <ros/advertise_options.h>
#include <ros/node_handle.h>
#include <ros/topic_manager.h>

#include <cstdint>
#include <string>

namespace rubber_suspension::ros_interface {

class AnswerLink;

/// Publishes from one thread at a time. If messages come in a burst, publish() waits for roscpp's network thread, so
/// that the queue of a subscriber does not overflow. So a subscriber that keeps reading receives every message.
class AnswerPublisher {
 public:
  AnswerPublisher() = default;
  ~AnswerPublisher() { shutdown(); }
  AnswerPublisher(const AnswerPublisher&) = delete;
  AnswerPublisher& operator=(const AnswerPublisher&) = delete;

  /// `queue_size`, at least 2, is the number of messages that may wait for each subscriber before the oldest is lost.
  template <class Message>
  void advertise(ros::NodeHandle& handle, const std::string& topic, std::uint32_t queue_size) {
    ros::AdvertiseOptions options;
    options.init<Message>(topic, queue_size);
    advertise(handle, options);
  }

  /// Publishes a message, which must not be changed while others have a pointer to it.
  template <class Message>
  void publish(const boost::shared_ptr<Message>& message) {
    ros::SerializedMessage unserialized;  // subscribers in this process receive the message itself
    unserialized.type_info = &typeid(Message);
    unserialized.message = message;
    send([&message] { return ros::serialization::serializeMessage(*message); }, unserialized);
  }

  /// Returns the number of messages that at least one subscriber lost because its queue was full. Messages that a
  /// subscriber had not read when it disconnected are not counted.
  std::uint64_t undelivered() const;

  void shutdown();

 private:
  void advertise(ros::NodeHandle& handle, ros::AdvertiseOptions& options);
  void send(const boost::function<ros::SerializedMessage()>& serialized, ros::SerializedMessage& unserialized);

  ros::Publisher publisher_;
  ros::PublicationPtr publication_;
  boost::shared_ptr<AnswerLink> link_;
};

}  // namespace rubber_suspension::ros_interface
