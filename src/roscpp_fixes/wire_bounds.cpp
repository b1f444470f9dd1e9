// Bounds to what peers send, before roscpp takes memory or time for it.
#include "roscpp_fixes/wire_bounds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/connection.h>
#include <ros/publisher_link.h>
#include <ros/subscription.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcServerConnection.h>

#include <array>
#include <boost/shared_array.hpp>
#include <cerrno>
#include <cstdio>
#include <map>
#include <mutex>
#include <vector>

#include "roscpp_fixes/replaced_function.h"
#include "roscpp_fixes/xmlrpc_body.h"

namespace rubber_suspension::roscpp_fixes {
namespace {

using XmlRpc::XmlRpcClient;
using XmlRpc::XmlRpcServerConnection;

constexpr std::size_t kLongestHttpHeader = 1U << 16U;   // [bytes]
constexpr std::uint32_t kLongestRosHeader = 1U << 20U;  // [bytes], which holds the definition of a message
constexpr std::size_t kMostAtOnce = 1U << 18U;          // bytes that are read before another connection has its turn

// The process's log may be what waits for the call that is refused.
void tellOnce(std::once_flag& told, const std::string& what) {
  std::call_once(told, [&] { fmt::print(stderr, "{}; said once\n", what); });
}

// Members that XmlRpcpp opens to derived classes alone.
struct ClientAccess : XmlRpcClient {
  static constexpr auto state() { return &ClientAccess::_connectionState; }
  static constexpr auto kHeader = READ_HEADER;
  static constexpr auto kBody = READ_RESPONSE;
};

struct ServerAccess : XmlRpcServerConnection {
  static constexpr auto state() { return &ServerAccess::_connectionState; }
  static constexpr auto kHeader = READ_HEADER;
  static constexpr auto header() { return &ServerAccess::_header; }
  static constexpr auto request() { return &ServerAccess::_request; }
  static constexpr auto length() { return &ServerAccess::_contentLength; }
  static constexpr auto refuse() { return &ServerAccess::generateFaultResponse; }
};

struct LinkAccess : ros::PublisherLink {
  static constexpr auto subscription() { return &LinkAccess::parent_; }
};

using HandleServer = unsigned(XmlRpcServerConnection*, unsigned);
using HandleClient = unsigned(XmlRpcClient*, unsigned);
using ExecuteRequest = void(XmlRpcServerConnection*);
using ParseResponse = bool(XmlRpcClient*, XmlRpc::XmlRpcValue&);
using ReadLength = void(void*, const ros::ConnectionPtr&, const boost::shared_array<std::uint8_t>&, std::uint32_t,
                        bool);

// The functions that ours take the place of.
void* handle_server;
void* handle_client;
void* execute_request;
void* parse_response;
void* read_available;
void* read_header_length;
void* read_message_length;
void* read_request_length;

std::once_flag told_of_request;
std::once_flag told_of_reply;
std::once_flag told_of_header;

// 0 lets the connection be closed.
unsigned handleServer(XmlRpcServerConnection* self, unsigned event) {
  const unsigned next = reinterpret_cast<HandleServer*>(handle_server)(self, event);
  const bool is_long_header = next != 0 && self->*ServerAccess::state() == ServerAccess::kHeader &&
                              (self->*ServerAccess::header()).size() > kLongestHttpHeader;
  if (next == 0 || (!is_long_header && self->*ServerAccess::length() <= static_cast<int>(kLongestRequest))) {
    return next;
  }
  tellOnce(told_of_request, fmt::format("a call to the slave API was refused: {}; accepted: at most {} bytes",
                                        is_long_header ? "a header without an end"
                                                       : fmt::format("{} bytes", self->*ServerAccess::length()),
                                        is_long_header ? kLongestHttpHeader : kLongestRequest));
  return 0;
}

unsigned handleClient(XmlRpcClient* self, unsigned event) {
  const unsigned next = reinterpret_cast<HandleClient*>(handle_client)(self, event);
  const auto state = self->*ClientAccess::state();
  const bool is_long_header = state == ClientAccess::kHeader && self->_header.size() > kLongestHttpHeader;
  const bool is_long_body = state == ClientAccess::kBody && self->_contentLength > static_cast<int>(kLongestReply);
  if (next == 0 || (!is_long_header && !is_long_body)) {
    return next;
  }
  tellOnce(told_of_reply,
           fmt::format("a reply of {}:{} was refused: {}; accepted: at most {} bytes", self->getHost(), self->getPort(),
                       is_long_header ? "a header without an end" : fmt::format("{} bytes", self->_contentLength),
                       is_long_header ? kLongestHttpHeader : kLongestReply));
  return 0;
}

void executeRequest(XmlRpcServerConnection* self) {
  const std::string refusal = requestRefusal(self->*ServerAccess::request());
  if (refusal.empty()) {
    reinterpret_cast<ExecuteRequest*>(execute_request)(self);
    return;
  }
  tellOnce(told_of_request, "a call to the slave API was refused: " + refusal);
  (self->*ServerAccess::refuse())(refusal, -1);
}

bool parseResponse(XmlRpcClient* self, XmlRpc::XmlRpcValue& result) {
  const std::string refusal = replyRefusal(self->_response);
  if (refusal.empty()) {
    return reinterpret_cast<ParseResponse*>(parse_response)(self, result);
  }
  tellOnce(told_of_reply, fmt::format("a reply of {}:{} was refused: {}", self->getHost(), self->getPort(), refusal));
  self->_response.clear();
  self->_header.clear();
  return false;
}

// XmlRpcpp's own reads on as long as more comes in.
bool readAvailable(int file, std::string& text, bool* is_end) {
  std::array<char, 16384> piece;
  *is_end = false;
  for (std::size_t all = 0; all < kMostAtOnce;) {
    const ssize_t size = read(file, piece.data(), piece.size());
    if (size <= 0) {
      *is_end = size == 0;
      return size == 0 || errno == EINPROGRESS || errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    }
    text.append(piece.data(), static_cast<std::size_t>(size));
    all += static_cast<std::size_t>(size);
  }
  return true;
}

struct Limit {
  std::uint32_t longest;
  std::atomic<std::uint64_t>* refused;
};

std::mutex limits_mutex;
std::multimap<std::string, Limit> limits;  // by topic or service

// The length stands in four bytes, least significant first.
std::uint32_t claimOf(const boost::shared_array<std::uint8_t>& buffer) {
  std::uint32_t claim = 0;
  for (unsigned byte = 0; byte < sizeof(claim); ++byte) {
    claim |= std::uint32_t{buffer[byte]} << 8U * byte;
  }
  return claim;
}

bool isBeyondLimit(const std::string& name, const boost::shared_array<std::uint8_t>& buffer) {
  const std::lock_guard<std::mutex> lock(limits_mutex);
  const auto limit = limits.find(name);
  const bool is_beyond = limit != limits.end() && claimOf(buffer) > limit->second.longest;
  if (is_beyond && limit->second.refused != nullptr) {
    ++*limit->second.refused;
  }
  return is_beyond;
}

// Of a pointer to a member function the lowest bit says that it is virtual: what takes the place of one is aligned, as
// functions of no class need not be.
[[gnu::aligned(16)]] void readHeaderLength(void* self, const ros::ConnectionPtr& connection,
                                           const boost::shared_array<std::uint8_t>& buffer, std::uint32_t size,
                                           bool success) {
  if (success && claimOf(buffer) > kLongestRosHeader) {
    tellOnce(told_of_header, fmt::format("a connection was closed: its header claims {} bytes; accepted: at most {}",
                                         claimOf(buffer), kLongestRosHeader));
    connection->drop(ros::Connection::HeaderError);
  } else {
    reinterpret_cast<ReadLength*>(read_header_length)(self, connection, buffer, size, success);
  }
}

[[gnu::aligned(16)]] void readMessageLength(void* self, const ros::ConnectionPtr& connection,
                                            const boost::shared_array<std::uint8_t>& buffer, std::uint32_t size,
                                            bool success) {
  const auto subscription = (static_cast<ros::PublisherLink*>(self)->*LinkAccess::subscription()).lock();
  if (success && subscription && isBeyondLimit(subscription->getName(), buffer)) {
    connection->drop(ros::Connection::Destructing);  // which roscpp takes as a reason not to connect again
  } else {
    reinterpret_cast<ReadLength*>(read_message_length)(self, connection, buffer, size, success);
  }
}

[[gnu::aligned(16)]] void readRequestLength(void* self, const ros::ConnectionPtr& connection,
                                            const boost::shared_array<std::uint8_t>& buffer, std::uint32_t size,
                                            bool success) {
  std::string service;
  if (success && connection->getHeader().getValue("service", service) && isBeyondLimit(service, buffer)) {
    connection->drop(ros::Connection::Destructing);
  } else {
    reinterpret_cast<ReadLength*>(read_request_length)(self, connection, buffer, size, success);
  }
}

template <class Function>
void* addressOf(Function* function) {
  return reinterpret_cast<void*>(function);
}

}  // namespace

std::string boundTheWire() {
  static const std::vector<std::string> missing = replaceFunctions(
      {{"_ZN6XmlRpc22XmlRpcServerConnection11handleEventEj", addressOf(handleServer), &handle_server},
       {"_ZN6XmlRpc12XmlRpcClient11handleEventEj", addressOf(handleClient), &handle_client},
       {"_ZN6XmlRpc22XmlRpcServerConnection14executeRequestEv", addressOf(executeRequest), &execute_request},
       {"_ZN6XmlRpc12XmlRpcClient13parseResponseERNS_11XmlRpcValueE", addressOf(parseResponse), &parse_response},
       {"_ZN6XmlRpc12XmlRpcSocket6nbReadEiRNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEPb",
        addressOf(readAvailable), &read_available},
       {"_ZN3ros10Connection18onHeaderLengthReadERKN5boost10shared_ptrIS0_EERKNS1_12shared_arrayIhEEjb",
        addressOf(readHeaderLength), &read_header_length},
       {"_ZN3ros22TransportPublisherLink15onMessageLengthERKN5boost10shared_ptrINS_10ConnectionEEERKNS1_12shared_"
        "arrayIhEEjb",
        addressOf(readMessageLength), &read_message_length},
       {"_ZN3ros17ServiceClientLink15onRequestLengthERKN5boost10shared_ptrINS_10ConnectionEEERKNS1_12shared_"
        "arrayIhEEjb",
        addressOf(readRequestLength), &read_request_length}});
  return missing.empty() ? ""
                         : fmt::format("this roscpp reads without bounds: {} is not found", fmt::join(missing, ", "));
}

std::shared_ptr<const void> limitMessages(const std::string& name, std::uint32_t longest,
                                          std::atomic<std::uint64_t>* refused) {
  const std::lock_guard<std::mutex> lock(limits_mutex);
  const auto added = limits.insert({name, {longest, refused}});
  return {nullptr, [added](const void*) {
            const std::lock_guard<std::mutex> last_lock(limits_mutex);
            limits.erase(added);
          }};
}

}  // namespace rubber_suspension::roscpp_fixes
