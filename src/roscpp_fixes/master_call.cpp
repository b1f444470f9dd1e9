// XML-RPC calls that end.
#include "roscpp_fixes/master_call.h"

#include <ros/datatypes.h>
#include <ros/master.h>
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
using Clock = std::chrono::steady_clock;

class Client : public XmlRpc::XmlRpcClient {
 public:
  Client(const std::string& host, std::uint32_t port) : XmlRpcClient(host.c_str(), static_cast<int>(port), "/") {}
  ~Client() override { close(); }

  bool callWithin(double limit, const std::string& method, const XmlRpcValue& arguments, XmlRpcValue& answer,
                  const std::atomic<bool>& stop) {
    constexpr double kTurn = 0.05;  // how long `stop` may go unseen [s]
    const auto end = Clock::now() + std::chrono::duration<double>(limit);
    if (!executeNonBlock(method.c_str(), arguments)) {
      return false;
    }
    while (!stop && Clock::now() < end && _connectionState != NO_CONNECTION) {
      _disp.work(std::min(kTurn, limit));
      if (executeCheckDone(answer)) {
        return !isFault();
      }
    }
    return false;
  }
};

}  // namespace

XmlRpcValue callArguments(const std::vector<std::string>& arguments) {
  XmlRpcValue value;
  value[0] = ros::this_node::getName();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    value[static_cast<int>(i) + 1] = arguments[i];
  }
  return value;
}

bool callAny(double limit, const std::string& host, std::uint32_t port, const std::string& method,
             const XmlRpcValue& arguments, XmlRpcValue& answer, const std::atomic<bool>& stop) {
  try {
    return Client(host, port).callWithin(limit, method, arguments, answer, stop);
  } catch (const XmlRpc::XmlRpcException&) {
    return false;
  }
}

std::optional<int> callWithin(double limit, const std::string& host, std::uint32_t port, const std::string& method,
                              const XmlRpcValue& arguments, XmlRpcValue& payload, const std::atomic<bool>& stop) {
  XmlRpcValue answer;
  if (!callAny(limit, host, port, method, arguments, answer, stop) || answer.getType() != XmlRpcValue::TypeArray ||
      answer.size() != 3 || answer[0].getType() != XmlRpcValue::TypeInt) {
    return std::nullopt;
  }
  payload = answer[2];
  return static_cast<int>(answer[0]);
}

std::optional<int> callMaster(double limit, const std::string& method, const XmlRpcValue& arguments,
                              XmlRpcValue& payload, const std::atomic<bool>& stop) {
  return callWithin(limit, ros::master::getHost(), ros::master::getPort(), method, arguments, payload, stop);
}

bool masterAnswers(double limit) { return masterAnswers(limit, ros::master::getHost(), ros::master::getPort()); }

bool masterAnswers(double limit, const std::string& host, std::uint32_t port) {
  XmlRpcValue payload;
  return callWithin(limit, host, port, "getPid", callArguments({}), payload, std::atomic<bool>{false}).has_value();
}

void giveUpMaster() { ros::master::init({{"__master", "http://127.0.0.1:1"}}); }

}  // namespace rubber_suspension::roscpp_fixes
