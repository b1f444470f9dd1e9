// A publisher that loses no burst, and that knows how many messages were lost to subscribers that read too slowly:
// roscpp's own drops them, and says nothing.
#pragma once

#include <ros/advertise_options.h>
#include <ros/node_handle.h>
#include <ros/topic_manager.h>

#include <cstdint>
#include <string>

namespace rubber_suspension::ros_interface {

class AnswerLink;

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
    ros::AdvertiseOptions options;
    options.init<Message>(topic, queue_size);
    advertise(handle, options);
  }

  /// The message must not be changed any more while others hold it.
  template <class Message>
  void publish(const boost::shared_ptr<Message>& message) {
    ros::SerializedMessage unserialized;  // for subscribers in this process
    unserialized.type_info = &typeid(Message);
    unserialized.message = message;
    send([&message] { return ros::serialization::serializeMessage(*message); }, unserialized);
  }

  /// Messages that at least one subscriber did not get because too many were waiting for it. Those that a subscriber
  /// did not read before it went are not among them.
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
