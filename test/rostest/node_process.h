// A running node as seen from outside: its slave API, process and memory. Also a subscriber that stalls.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <ros/header.h>
#include <ros/master.h>
#include <ros/message_traits.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <string>

namespace rubber_suspension {

/// Calls the slave API of a node with `arguments` after the caller's name. Returns an invalid value without an answer.
inline XmlRpc::XmlRpcValue askNode(const std::string& node, const std::string& method,
                                   XmlRpc::XmlRpcValue arguments = XmlRpc::XmlRpcValue()) {
  XmlRpc::XmlRpcValue lookup;
  lookup[0] = arguments[0] = ros::this_node::getName();
  lookup[1] = node;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", lookup, response, uri, false) ||
      !ros::network::splitURI(static_cast<std::string&>(uri), host, port)) {
    return {};
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue answer;
  const bool answered = client.execute(method.c_str(), arguments, answer);
  client.close();
  return answered && answer.getType() == XmlRpc::XmlRpcValue::TypeArray && answer.size() == 3 ? answer[2]
                                                                                              : XmlRpc::XmlRpcValue();
}

/// Returns the process of a node, or 0 if the node does not answer.
inline pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue answer = askNode(node, "getPid");
  return answer.getType() == XmlRpc::XmlRpcValue::TypeInt ? static_cast<int>(answer) : 0;
}

/// A subscriber that connects and then reads nothing. Its receive buffer is small, so that messages accumulate at the
/// sender.
template <class Message>
class StalledSubscriber {
 public:
  StalledSubscriber(const std::string& node, const std::string& topic) {
    XmlRpc::XmlRpcValue request;
    request[1] = topic;
    request[2][0][0] = "TCPROS";
    XmlRpc::XmlRpcValue answer = askNode(node, "requestTopic", request);
    if (answer.getType() == XmlRpc::XmlRpcValue::TypeArray && answer.size() == 3) {
      open(static_cast<int>(answer[2]));
      greet(topic);
    }
  }
  ~StalledSubscriber() { close(socket_); }
  StalledSubscriber(const StalledSubscriber&) = delete;
  StalledSubscriber& operator=(const StalledSubscriber&) = delete;

  /// Returns true if the sender has answered the connection header.
  bool connected() const {
    pollfd waiting{socket_, POLLIN, 0};
    return connected_ && poll(&waiting, 1, 10000) == 1;
  }

  /// Returns the number of bytes that have arrived but were not read.
  int unread() const {
    int bytes = 0;
    return ioctl(socket_, FIONREAD, &bytes) == 0 ? bytes : 0;
  }

 private:
  void open(int port) {
    constexpr int kSmall = 4096;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &kSmall, sizeof(kSmall));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    connected_ = connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  }

  void greet(const std::string& topic) {
    ros::M_string fields;
    fields["callerid"] = ros::this_node::getName() + "_stalled";
    fields["topic"] = topic;
    fields["type"] = ros::message_traits::datatype<Message>();
    fields["md5sum"] = ros::message_traits::md5sum<Message>();
    boost::shared_array<std::uint8_t> header;
    std::uint32_t size = 0;
    ros::Header::write(fields, header, size);
    connected_ = connected_ && write(socket_, &size, sizeof(size)) == sizeof(size) &&
                 write(socket_, header.get(), size) == static_cast<ssize_t>(size);
  }

  int socket_ = socket(AF_INET, SOCK_STREAM, 0);
  bool connected_ = false;
};

}  // namespace rubber_suspension
