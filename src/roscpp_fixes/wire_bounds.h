// Bounds to what peers send, before roscpp takes memory or time for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace rubber_suspension::roscpp_fixes {

/// Bound all that comes in over the wire to this process, once and until it ends: a body of XML-RPC as xmlrpc_body.h
/// has it, a header of HTTP at 64 KiB, a header of TCPROS at 1 MiB, and messages and requests of services as
/// limitMessages() says. What is beyond fails the call or closes the connection; the first of each kind is told on
/// stderr. Call it before ROS runs, or once it is loaded. Returns what this roscpp does not let us bound, or nothing.
std::string boundTheWire();

/// As long as what is returned exists, a connection over which a message of this resolved topic, or a request to this
/// resolved service, claims more than `longest` [bytes] is closed before there is memory for it, and counted.
std::shared_ptr<const void> limitMessages(const std::string& name, std::uint32_t longest,
                                          std::atomic<std::uint64_t>* refused = nullptr);

}  // namespace rubber_suspension::roscpp_fixes
