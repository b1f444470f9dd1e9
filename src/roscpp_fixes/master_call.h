// XML-RPC calls that end: roscpp's own wait for ever for a master or node that hangs.
#pragma once

#include <ros/master.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// The arguments of a call, this node's name first.
XmlRpc::XmlRpcValue callArguments(const std::vector<std::string>& arguments = {});

/// Call a method at an address (http://HOST:PORT) within `limit` [s], less once `stop` is set. Returns what came back,
/// from masters and nodes [status, text, payload] with status 1 where it was done; nothing where no answer came, or a
/// fault. What comes back may be anything: XmlRpcValue throws XmlRpcException where it is not what it is taken for.
std::optional<XmlRpc::XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                        const XmlRpc::XmlRpcValue& arguments, const std::atomic<bool>* stop = nullptr);

/// True if the master at this address answers within `limit` [s].
inline bool masterAnswers(double limit, const std::string& uri = ros::master::getURI()) {
  return call(limit, uri, "getPid", callArguments()).has_value();
}

/// From now on roscpp calls nobody in the master's place: each call fails at once. For the end of a process whose
/// master hangs, since roscpp waits without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

}  // namespace rubber_suspension::roscpp_fixes
