// XML-RPC calls that end: roscpp's own wait for ever for a master or node that hangs.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// The arguments of a call, this node's name first.
XmlRpc::XmlRpcValue callArguments(const std::vector<std::string>& arguments);

/// Call a method at host and port within `limit` [s], less once `stop` is set; false where no answer came, or a fault.
bool callAny(double limit, const std::string& host, std::uint32_t port, const std::string& method,
             const XmlRpc::XmlRpcValue& arguments, XmlRpc::XmlRpcValue& answer, const std::atomic<bool>& stop);

/// Call a method at host and port within `limit` [s], less once `stop` is set. Returns the status, 1 where it was done,
/// and in `payload` what came with it; nothing where no answer of that form came.
std::optional<int> callWithin(double limit, const std::string& host, std::uint32_t port, const std::string& method,
                              const XmlRpc::XmlRpcValue& arguments, XmlRpc::XmlRpcValue& payload,
                              const std::atomic<bool>& stop);

/// Call a method of the master in the same way.
std::optional<int> callMaster(double limit, const std::string& method, const XmlRpc::XmlRpcValue& arguments,
                              XmlRpc::XmlRpcValue& payload, const std::atomic<bool>& stop);

/// True if the master, or the one at this address, answers within `limit` [s].
bool masterAnswers(double limit);
bool masterAnswers(double limit, const std::string& host, std::uint32_t port);

/// From now on roscpp calls nobody in the master's place: each call fails at once. For the end of a process whose
/// master hangs, since roscpp waits without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

}  // namespace rubber_suspension::roscpp_fixes
