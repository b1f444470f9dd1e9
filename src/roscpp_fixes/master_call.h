// XML-RPC calls that end: roscpp's own wait for ever for a master or node that hangs.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// What came of a call to a master.
enum class CallResult {
  done,      ///< status 1: the payload is that of the answer
  refused,   ///< an answer, but not of status 1
  no_answer  ///< none in time, or none that is an answer
};

/// The arguments of a call, this node's name first.
XmlRpc::XmlRpcValue callArguments(const std::vector<std::string>& arguments);

/// Call a method at host and port within `limit` [s], less once `stop` is set. False where no answer came.
bool callWithin(double limit, const std::string& host, std::uint32_t port, const std::string& method,
                const XmlRpc::XmlRpcValue& arguments, XmlRpc::XmlRpcValue& answer, const std::atomic<bool>& stop);

/// Call a method of the master in the same way.
CallResult callMaster(double limit, const std::string& method, const XmlRpc::XmlRpcValue& arguments,
                      XmlRpc::XmlRpcValue& payload, const std::atomic<bool>& stop);

/// True for what a master or a node answers: status, message, payload.
bool isAnswer(const XmlRpc::XmlRpcValue& answer);

/// True if the master answers within `limit` [s].
bool masterAnswers(double limit);

/// The same of the master at this address.
bool masterAnswers(double limit, const std::string& host, std::uint32_t port);

/// From now on roscpp calls nobody in the master's place: each call fails at once. For the end of a process whose
/// master hangs, since roscpp waits without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

}  // namespace rubber_suspension::roscpp_fixes
