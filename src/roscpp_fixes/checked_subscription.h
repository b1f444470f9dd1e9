// Subscriptions whose messages are looked at before they are decoded: what is none costs no memory and no line of log.
#pragma once

#include <ros/node_handle.h>
#include <ros/subscription_callback_helper.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace rubber_suspension::roscpp_fixes {

/// True if these bytes are a message of the topic.
using MessageCheck = std::function<bool(const std::uint8_t* data, std::size_t size)>;
/// Decodes what passes the check and counts the rest. roscpp alone makes room for whatever number of entries a message
/// claims to have, and writes a line of log for each that it cannot decode.
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

/// Subscribe without delay (TCP_NODELAY). `refused` counts the messages that did not pass the check; it must outlive
/// the subscription.
template <class Message>
ros::Subscriber subscribeChecked(ros::NodeHandle& handle, const std::string& topic, std::uint32_t queue_size,
                                 MessageCheck check, std::atomic<std::uint64_t>& refused,
                                 const boost::function<void(const ros::MessageEvent<const Message>&)>& callback) {
  ros::SubscribeOptions options(topic, queue_size, ros::message_traits::md5sum<Message>(),
                                ros::message_traits::datatype<Message>());
  options.helper = boost::make_shared<CheckedCallback<Message>>(callback, std::move(check), refused);
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return handle.subscribe(options);
}

}  // namespace rubber_suspension::roscpp_fixes
