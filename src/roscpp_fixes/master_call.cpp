// XML-RPC calls that end.
#include "roscpp_fixes/master_call.h"

#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <chrono>

// roscpp has it, and ros::init() calls it, but no header tells.
namespace ros::master {
void init(const M_string& remappings);
}

namespace rubber_suspension::roscpp_fixes {
namespace {

using XmlRpc::XmlRpcValue;

class Client : public XmlRpc::XmlRpcClient {
 public:
  using XmlRpcClient::XmlRpcClient;
  ~Client() override { close(); }

  bool callWithin(double limit, const std::string& method, const XmlRpcValue& arguments, XmlRpcValue& answer,
                  const std::atomic<bool>* stop) {
    using Clock = std::chrono::steady_clock;
    constexpr double kTurn = 0.05;  // how long `stop` may go unseen [s]
    const auto end = Clock::now() + std::chrono::duration<double>(limit);
    const bool begun = executeNonBlock(method.c_str(), arguments);
    while (begun && (stop == nullptr || !*stop) && Clock::now() < end && _connectionState != NO_CONNECTION) {
      _disp.work(std::min(kTurn, limit));
      if (executeCheckDone(answer)) {
        return !isFault() && answer.valid();
      }
    }
    return false;
  }
};

}  // namespace

XmlRpcValue callArguments(const std::vector<std::string>& arguments) {
  XmlRpcValue value;
  value[0] = ros::this_node::getName();
  for (const std::string& argument : arguments) {
    value[value.size()] = argument;
  }
  return value;
}

std::optional<XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                const XmlRpcValue& arguments, const std::atomic<bool>* stop) {
  std::string host;
  std::uint32_t port = 0;
  XmlRpcValue answer;
  try {
    const bool came =
        ros::network::splitURI(uri, host, port) &&
        Client(host.c_str(), static_cast<int>(port), "/").callWithin(limit, method, arguments, answer, stop);
    return came ? std::make_optional(answer) : std::nullopt;
  } catch (const XmlRpc::XmlRpcException&) {
    return std::nullopt;  // no XML-RPC came back
  }
}

void giveUpMaster() { ros::master::init({{"__master", "http://127.0.0.1:1"}}); }

}  // namespace rubber_suspension::roscpp_fixes
